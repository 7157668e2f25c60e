#include "read_image.h"

#include <algorithm>
#include <cctype>

#include "decode_pgm.h"
#include "decode_png.h"
#include "flip_rows.h"

namespace roomgraph {
namespace {

constexpr const char* kSaveAgain = "copy or save the picture again";

void setSize(GreyMap& map, std::uint64_t width, std::uint64_t height, const std::string& file) {
  checkPictureSize(width, height, file);
  map.frame.width = int(width);
  map.frame.height = int(height);
}

std::uint8_t scaled(std::uint64_t value, std::uint64_t brightest) {
  return std::uint8_t((std::min(value, brightest) * 255 + brightest / 2) / brightest);
}

void readPgm(CheckedFile& file, GreyMap& map) {
  const PgmHeader header = readPgmHeader(ByteReader(file.head(), file.name()));
  setSize(map, header.width, header.height, file.name());
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
  setSize(map, header.width, header.height, file.name());
  const ByteView png = file.content();
  checkPng(ByteReader(png, file.name()), header);
  map.grey = decodePng(png, file.name());
  flipRows(map.grey, header.width);
}

}  // namespace

void checkPictureSize(std::uint64_t width, std::uint64_t height, const std::string& file) {
  if (width == 0 || height == 0) refuse(file, "has no pixels", kSaveAgain);
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

void readImage(CheckedFile& file, GreyMap& map) {
  if (isPng(file.head()))
    readPng(file, map);
  else if (isPgm(file.head()))
    readPgm(file, map);
  else
    refuse(file.name(), "is no picture of a known kind", "convert it to png or pgm (P2, P5)");
}

}  // namespace roomgraph
