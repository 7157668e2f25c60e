#include <algorithm>
#include <cctype>
#include <limits>

#include "decoders.h"
#include "roomgraph/base/checked_file.h"

namespace roomgraph {
namespace {

/** The next whole number of a pgm, with blanks and comments before it. */
std::uint64_t readPgmNumber(ByteReader& reader) {
  const auto next = [&reader] { return reader.left() > 0 ? int(*reader.peek()) : -1; };
  while (std::isspace(next()) || next() == '#') {
    if (next() == '#') {
      while (next() >= 0 && next() != '\n') reader.skip(1);
      // Of a header, only the first bytes of the file are here.
      if (next() < 0)
        refuse(reader.file(), "a comment in it is cut short, or longer than 64 KB",
               kSavePictureAgain);
    } else {
      reader.skip(1);
    }
  }
  if (next() >= 0 && !std::isdigit(next()))
    refuse(reader.file(), "it is damaged: a number is missing in it", kSavePictureAgain);
  std::uint64_t number = 0;
  int digits = 0;
  for (; std::isdigit(next()) && digits < 10; ++digits)
    number = number * 10 + std::uint64_t(*reader.take(1) - '0');
  if (digits == 0) reader.skip(1);  // the end of the file
  return number;
}

std::size_t bytesPerPixel(const PgmHeader& header) {
  return header.isText ? 2 : header.brightest < 256 ? 1 : 2;
}

std::uint32_t readPixel(ByteReader& reader, const PgmHeader& header) {
  if (header.isText) {
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
    return std::uint32_t(std::min(readPgmNumber(reader), most));
  }
  std::uint32_t value = 0;
  for (std::size_t b = 0; b < bytesPerPixel(header); ++b) value = value * 256 + *reader.take(1);
  return value;
}

void expectEnd(ByteReader& reader) {
  while (reader.left() > 0)
    if (!std::isspace(*reader.take(1)))
      refuse(reader.file(), "something follows the picture in it", "remove what was appended");
}

}  // namespace

PgmHeader readPgmHeader(ByteReader reader) {
  PgmHeader header;
  header.isText = reader.take(2)[1] == '2';
  header.width = readPgmNumber(reader);
  header.height = readPgmNumber(reader);
  header.brightest = readPgmNumber(reader);
  if (header.brightest == 0 || header.brightest > 65535)
    refuse(reader.file(), "it is damaged: its brightest value is not in 1 to 65535",
           kSavePictureAgain);
  reader.skip(1);
  header.size = reader.position();
  return header;
}

void checkPgm(CheckedFile& file, const PgmHeader& header) {
  const std::uint64_t pixelBytes = header.width * header.height * bytesPerPixel(header);
  // The last number of a text may end with the file.
  if (file.claimedSize() + 1 < header.size + pixelBytes)
    refuse(file.name(), "it is cut short: pixels are missing", kSavePictureAgain);
  ByteReader reader(file.content(), file.name());
  if (header.isText) return;  // its pixels tell where they end
  reader.skip(header.size + pixelBytes);
  expectEnd(reader);
}

void decodePgm(
    CheckedFile& file, const PgmHeader& header,
    const std::function<void(std::size_t row, const std::vector<std::uint32_t>&)>& take) {
  ByteReader reader(file.content(), file.name());
  reader.skip(header.size);
  std::vector<std::uint32_t> values(header.width);
  for (std::size_t row = header.height; row-- > 0;) {
    for (std::uint32_t& value : values) value = readPixel(reader, header);
    take(row, values);
  }
  expectEnd(reader);
}

}  // namespace roomgraph
