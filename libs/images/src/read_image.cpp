#include "roomgraph/images/read_image.h"

#include <algorithm>
#include <cctype>

#include "decoders.h"
#include "pixels.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

std::uint8_t scaled(std::uint64_t value, std::uint64_t brightest) {
  return std::uint8_t((std::min(value, brightest) * 255 + brightest / 2) / brightest);
}

void readPgm(CheckedFile& file, GreyMap& map) {
  const PgmHeader header = readPgmHeader(ByteReader(file.head(), file.name()));
  setSize(map.frame, header, file.name());
  checkPgm(file, header);
  map.grey.resize(map.frame.cellCount());
  decodePgm(file, header, [&](std::size_t row, const std::vector<std::uint32_t>& values) {
    std::transform(values.begin(), values.end(),
                   map.grey.begin() + std::ptrdiff_t(row * values.size()),
                   [&](std::uint32_t value) { return scaled(value, header.brightest); });
  });
}

void readPng(CheckedFile& file, GreyMap& map) {
  const PngHeader header = readPngHeader(ByteReader(file.head(), file.name()));
  setSize(map.frame, header, file.name());
  const ByteView png = file.content();
  checkPng(ByteReader(png, file.name()), header);
  map.grey = decodePng(png, file.name());
  flipRows(map.grey, header.width);
}

/** What `of` gives of each pixel of a checked bmp, the lowest row first. */
template <class Of>
std::vector<std::uint8_t> pixelsOfBmp(CheckedFile& file, const BmpHeader& header, const Of& of) {
  std::vector<std::uint8_t> all(header.width * header.height);
  decodeBmp(file, header, [&](std::size_t row, const std::vector<BmpPixel>& pixels) {
    std::transform(pixels.begin(), pixels.end(), all.begin() + std::ptrdiff_t(row * pixels.size()),
                   of);
  });
  return all;
}

void readBmp(CheckedFile& file, GreyMap& map) {
  const BmpHeader header = readBmpHeader(ByteReader(file.head(), file.name()));
  setSize(map.frame, header, file.name());
  checkBmp(file, header);
  map.grey = pixelsOfBmp(file, header, [](const BmpPixel& p) {
    return overBackground(averaged(p[0], p[1], p[2]), p[3]);
  });
}

void readJpeg(CheckedFile& file, GreyMap& map) {
  map.grey = decodeJpeg(file.content(), file.name(), map.frame);
  flipRows(map.grey, std::size_t(map.frame.width));
}

struct Kind {
  bool (*looksLike)(ByteView head);
  void (*read)(CheckedFile& file, GreyMap& map);
};

constexpr Kind kKinds[] = {
    {isPng, readPng}, {isPgm, readPgm}, {isBmp, readBmp}, {isJpeg, readJpeg}};

const Kind* kindOf(ByteView head) {
  return findIf(kKinds, [&](const Kind& kind) { return kind.looksLike(head); });
}

std::vector<std::uint8_t> clearPixelsOfPng(CheckedFile& file) {
  const PngHeader header = readPngHeader(ByteReader(file.head(), file.name()));
  std::vector<std::uint8_t> isClear = decodePngClear(file.content(), file.name());
  flipRows(isClear, header.width);
  return isClear;
}

std::vector<std::uint8_t> clearPixelsOfBmp(CheckedFile& file) {
  const BmpHeader header = readBmpHeader(ByteReader(file.head(), file.name()));
  return pixelsOfBmp(file, header, [](const BmpPixel& p) { return std::uint8_t(p[3] < 255); });
}

}  // namespace

void checkPictureSize(std::uint64_t width, std::uint64_t height, const std::string& file) {
  if (width == 0 || height == 0) refuse(file, "has no pixels", kSavePictureAgain);
  if (width > kMostCells || height > kMostCells || width * height > kMostCells)
    refuse(file,
           "claims " + std::to_string(width) + " x " + std::to_string(height) +
               " pixels, more than 400 million",
           "crop it or scale it down");
}

bool isPng(ByteView head) {
  constexpr std::uint8_t signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  return head.size >= sizeof signature && std::equal(signature, std::end(signature), head.data);
}

bool isPgm(ByteView head) {
  return head.size >= 3 && head.data[0] == 'P' && (head.data[1] == '2' || head.data[1] == '5') &&
         (std::isspace(head.data[2]) || head.data[2] == '#');
}

bool isImage(ByteView head) { return kindOf(head) != nullptr; }

void readImage(CheckedFile& file, GreyMap& map) {
  const Kind* kind = kindOf(file.head());
  if (!kind)
    refuse(file.name(), "is not a picture of a known kind", "convert it to png, pgm, bmp or jpeg");
  kind->read(file, map);
}

std::vector<std::uint8_t> readClearPixels(CheckedFile& file) {
  if (isPng(file.head())) return clearPixelsOfPng(file);
  if (isBmp(file.head())) return clearPixelsOfBmp(file);
  return {};
}

}  // namespace roomgraph
