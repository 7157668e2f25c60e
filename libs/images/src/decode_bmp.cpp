#include <cstdlib>

#include "decoders.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

constexpr std::uint32_t kFileHeaderSize = 14;
constexpr std::uint32_t kOldInfoSize = 12;  // OS/2's, with sizes of 16 bits
constexpr std::uint32_t kOs2InfoSize = 64;  // numbers its compressions in another way
constexpr std::uint32_t kInfoSizes[] = {kOldInfoSize, 40, 52, 56, kOs2InfoSize, 108, 124};
enum BmpCompression : std::uint32_t { kNone = 0, kMasks = 3, kMasksWithAlpha = 6 };

void readOldInfo(ByteReader& reader, BmpHeader& header) {
  header.width = reader.get<std::uint16_t>();
  header.height = reader.get<std::uint16_t>();
  reader.skip(2);  // planes
  header.bitsPerPixel = reader.get<std::uint16_t>();
}

/** Fills in the masks of a header of at least 40 bytes, which follow them or are part of it. */
void readMasks(ByteReader& reader, std::uint32_t infoSize, std::uint32_t compression,
               BmpHeader& header) {
  if (header.bitsPerPixel == 16) header.masks = {0x7c00, 0x03e0, 0x001f, 0};
  if (header.bitsPerPixel == 32) header.masks = {0xff0000, 0x00ff00, 0x0000ff, 0};
  if (compression == kNone) return;
  const bool hasAlpha = infoSize >= 56 || compression == kMasksWithAlpha;
  for (std::size_t i = 0; i < (hasAlpha ? 4u : 3u); ++i)
    header.masks[i] = reader.get<std::uint32_t>();
}

/** Returns how many colours the palette has. */
std::uint64_t readInfo(ByteReader& reader, std::uint32_t infoSize, BmpHeader& header) {
  const auto width = reader.get<std::int32_t>(), height = reader.get<std::int32_t>();
  if (width < 0) refuse(reader.file(), "it is damaged: its width is negative", kSavePictureAgain);
  header.width = std::uint64_t(width);
  header.isTopDown = height < 0;
  header.height = std::uint64_t(std::abs(std::int64_t(height)));
  reader.skip(2);  // planes
  header.bitsPerPixel = reader.get<std::uint16_t>();
  const auto compression = reader.get<std::uint32_t>();
  const bool hasMasks = compression == kMasks || compression == kMasksWithAlpha;
  if (compression != kNone && (!hasMasks || infoSize == kOs2InfoSize))
    refuse(reader.file(), "is a compressed bmp", "save it without compression, or as png");
  reader.skip(4 + 4 + 4);  // size of the pixels, dots per metre
  const auto colours = reader.get<std::uint32_t>();
  reader.skip(4);  // important ones
  readMasks(reader, infoSize, compression, header);
  return colours;
}

void readPalette(ByteReader& reader, std::uint64_t colours, bool isOld, BmpHeader& header) {
  const std::uint64_t most = std::uint64_t(1) << header.bitsPerPixel;
  if (colours == 0) colours = most;
  if (colours > most)
    refuse(reader.file(), "it is damaged: its palette is too long", kSavePictureAgain);
  for (; colours > 0; --colours) {
    const std::uint8_t* blueFirst = reader.take(isOld ? 3 : 4);
    header.palette.push_back({blueFirst[2], blueFirst[1], blueFirst[0]});
  }
}

std::uint64_t rowBytes(const BmpHeader& header) {
  return (header.width * std::uint64_t(header.bitsPerPixel) + 31) / 32 * 4;
}

/** The part of a pixel that a mask cuts out, on a scale up to 255. */
std::uint8_t maskedBits(std::uint32_t pixel, std::uint32_t mask) {
  if (mask == 0) return 0;
  std::uint64_t value = pixel & mask, most = mask;
  while ((most & 1) == 0) value >>= 1, most >>= 1;
  return std::uint8_t((value * 255 + most / 2) / most);
}

BmpPixel fromPalette(const std::uint8_t* row, std::size_t x, const BmpHeader& header,
                     const std::string& file) {
  const auto bits = std::size_t(header.bitsPerPixel);
  const std::size_t bit = x * bits;
  const auto index =
      std::size_t(row[bit / 8] >> (8 - bits - bit % 8)) & ((std::size_t(1) << bits) - 1);
  if (index >= header.palette.size())
    refuse(file, "it is damaged: a pixel is not in its palette", kSavePictureAgain);
  const auto& colour = header.palette[index];
  return {colour[0], colour[1], colour[2], 255};
}

BmpPixel pixelAt(const std::uint8_t* row, std::size_t x, const BmpHeader& header,
                 const std::string& file) {
  if (header.bitsPerPixel <= 8) return fromPalette(row, x, header, file);
  const auto bytes = std::size_t(header.bitsPerPixel / 8);
  const std::uint8_t* p = row + x * bytes;
  if (bytes == 3) return {p[2], p[1], p[0], 255};
  std::uint32_t pixel = 0;
  std::memcpy(&pixel, p, bytes);
  const auto& masks = header.masks;
  return {maskedBits(pixel, masks[0]), maskedBits(pixel, masks[1]), maskedBits(pixel, masks[2]),
          masks[3] ? maskedBits(pixel, masks[3]) : std::uint8_t(255)};
}

}  // namespace

bool isBmp(ByteView head) {
  if (head.size < kFileHeaderSize + 4 || head.data[0] != 'B' || head.data[1] != 'M') return false;
  std::uint32_t infoSize;
  std::memcpy(&infoSize, head.data + kFileHeaderSize, sizeof infoSize);
  return contains(kInfoSizes, infoSize);
}

BmpHeader readBmpHeader(ByteReader reader) {
  BmpHeader header;
  reader.skip(2);
  header.endsAt = reader.get<std::uint32_t>();
  reader.skip(4);
  header.pixelsAt = reader.get<std::uint32_t>();
  const auto infoSize = reader.get<std::uint32_t>();
  const bool isOld = infoSize == kOldInfoSize;
  std::uint64_t colours = 0;
  if (isOld)
    readOldInfo(reader, header);
  else
    colours = readInfo(reader, infoSize, header);
  constexpr int depths[] = {1, 4, 8, 16, 24, 32};
  if (!contains(depths, header.bitsPerPixel))
    refuse(reader.file(), "it is damaged: its kind of pixel is unknown", kSavePictureAgain);
  if (kFileHeaderSize + infoSize > reader.position())
    reader.skip(kFileHeaderSize + infoSize - reader.position());
  if (header.bitsPerPixel <= 8) readPalette(reader, colours, isOld, header);
  if (header.pixelsAt < reader.position())
    refuse(reader.file(), "it is damaged: its pixels begin within its header", kSavePictureAgain);
  return header;
}

void checkBmp(const CheckedFile& file, const BmpHeader& header) {
  if (file.claimedSize() < header.pixelsAt + header.height * rowBytes(header))
    refuse(file.name(), "it is cut short: pixels are missing", kSavePictureAgain);
}

void decodeBmp(CheckedFile& file, const BmpHeader& header,
               const std::function<void(std::size_t row, const std::vector<BmpPixel>&)>& take) {
  ByteReader reader(file.content(), file.name());
  reader.skip(header.pixelsAt);
  std::vector<BmpPixel> pixels(header.width);
  for (std::size_t i = 0; i < header.height; ++i) {
    const std::uint8_t* row = reader.take(rowBytes(header));
    for (std::size_t x = 0; x < pixels.size(); ++x)
      pixels[x] = pixelAt(row, x, header, file.name());
    take(header.isTopDown ? header.height - 1 - i : i, pixels);
  }
  // A colour profile may stand behind the pixels; the file's header counts it.
  if (reader.left() > 0 && reader.position() + reader.left() != header.endsAt)
    refuse(file.name(), "something follows the picture in it", "remove what was appended");
}

}  // namespace roomgraph
