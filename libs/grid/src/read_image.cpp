#include "read_image.h"

#include <algorithm>
#include <cctype>

#include "decode_png.h"

namespace roomgraph {
namespace {

constexpr const char* kSaveAgain = "copy or save the picture again";

void setSize(GreyMap& map, std::uint64_t width, std::uint64_t height, const std::string& file) {
  if (width == 0 || height == 0) refuse(file, "has no pixels", kSaveAgain);
  if (width > kMostCells || height > kMostCells || width * height > kMostCells)
    refuse(file,
           "claims " + std::to_string(width) + " x " + std::to_string(height) +
               " pixels, more than 400 million",
           "crop it or scale it down");
  map.frame.width = int(width);
  map.frame.height = int(height);
}

/** The next whole number of a pgm, with blanks and comments before it. */
std::uint64_t readPgmNumber(ByteReader& in) {
  const auto next = [&in] { return in.left() > 0 ? int(*in.peek()) : -1; };
  while (std::isspace(next()) || next() == '#') {
    if (next() == '#')
      while (next() >= 0 && next() != '\n') in.skip(1);
    else
      in.skip(1);
  }
  if (next() >= 0 && !std::isdigit(next()))
    refuse(in.file(), "it is damaged: a number is missing in it", kSaveAgain);
  std::uint64_t number = 0;
  int digits = 0;
  for (; std::isdigit(next()) && digits < 10; ++digits)
    number = number * 10 + std::uint64_t(*in.take(1) - '0');
  if (digits == 0) in.skip(1);  // the end of the file
  return number;
}

std::uint8_t scaled(std::uint64_t value, std::uint64_t brightest) {
  return std::uint8_t((value * 255 + brightest / 2) / brightest);
}

struct PgmHeader {
  bool isText = false;
  std::uint64_t width = 0, height = 0, brightest = 0;
};

PgmHeader readPgmHeader(ByteReader& in) {
  PgmHeader header;
  header.isText = in.take(2)[1] == '2';
  header.width = readPgmNumber(in);
  header.height = readPgmNumber(in);
  header.brightest = readPgmNumber(in);
  if (header.brightest == 0 || header.brightest > 65535)
    refuse(in.file(), "it is damaged: its brightest value is not in 1 to 65535", kSaveAgain);
  in.skip(1);
  return header;
}

void readPgm(CheckedFile& file, GreyMap& map) {
  ByteReader head(file.head(), file.name());
  const PgmHeader header = readPgmHeader(head);
  setSize(map, header.width, header.height, file.name());
  const std::size_t bytes = header.isText ? 2 : header.brightest < 256 ? 1 : 2;
  // The last number of a text may end with the file.
  if (file.claimedSize() + 1 < head.position() + map.frame.cellCount() * bytes)
    refuse(file.name(), "it is cut short: pixels are missing", kSaveAgain);

  ByteReader in(file.content(), file.name());
  in.skip(head.position());
  map.grey.resize(map.frame.cellCount());
  const auto width = std::size_t(map.frame.width);
  for (std::size_t row = std::size_t(map.frame.height); row-- > 0;)
    for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
      std::uint64_t value = 0;
      if (header.isText)
        value = readPgmNumber(in);
      else
        for (std::size_t b = 0; b < bytes; ++b) value = value * 256 + *in.take(1);
      map.grey[i] = scaled(std::min(value, header.brightest), header.brightest);
    }
  while (in.left() > 0)
    if (!std::isspace(*in.take(1)))
      refuse(file.name(), "something follows the picture in it", "remove what was appended");
}

/** From the top row first to the lowest row first. */
void flip(GreyMap& map) {
  const auto row = [&](int y) {
    return map.grey.begin() + std::ptrdiff_t(map.frame.index({0, y}));
  };
  for (int low = 0, high = map.frame.height - 1; low < high; ++low, --high)
    std::swap_ranges(row(low), row(low + 1), row(high));
}

void readPng(CheckedFile& file, GreyMap& map) {
  const PngHeader header = readPngHeader(ByteReader(file.head(), file.name()));
  setSize(map, header.width, header.height, file.name());
  const ByteView png = file.content();
  checkPng(ByteReader(png, file.name()), header);
  map.grey = decodePng(png, file.name());
  flip(map);
}

}  // namespace

bool isPng(ByteView head) {
  constexpr std::uint8_t signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  return head.size >= sizeof signature && std::equal(signature, std::end(signature), head.data);
}

bool isPgm(ByteView head) {
  return head.size >= 3 && head.data[0] == 'P' && (head.data[1] == '2' || head.data[1] == '5') &&
         (std::isspace(head.data[2]) || head.data[2] == '#');
}

void readImage(CheckedFile& file, GreyMap& map) {
  if (isPng(file.head()))
    readPng(file, map);
  else if (isPgm(file.head()))
    readPgm(file, map);
  else
    refuse(file.name(), "is no picture of a known kind", "convert it to png or pgm (P2, P5)");
}

}  // namespace roomgraph
