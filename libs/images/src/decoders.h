#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "roomgraph/base/byte_reader.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/images/read_image.h"

namespace roomgraph {

/** Gives what is read the size of its picture. Throws DataError like checkPictureSize(). */
template <class Sized, class Header>
void setSize(Sized& sized, const Header& header, const std::string& file) {
  checkPictureSize(header.width, header.height, file);
  sized.width = int(header.width);
  sized.height = int(header.height);
}

struct BmpHeader {
  std::uint64_t width = 0, height = 0;
  bool isTopDown = false;
  int bitsPerPixel = 0;
  std::uint64_t pixelsAt = 0, endsAt = 0;  ///< bytes from the start of the file
  std::array<std::uint32_t, 4> masks{};    ///< red, green, blue, alpha, for 16 and 32 bits
  std::vector<std::array<std::uint8_t, 3>> palette;  ///< red, green, blue, for up to 8 bits
};

/** Red, green, blue, alpha. */
using BmpPixel = std::array<std::uint8_t, 4>;

bool isBmp(ByteView head);
/** Reads what stands before the pixels of a bmp of any depth. Throws DataError where it is damaged
 *  or compressed. */
BmpHeader readBmpHeader(ByteReader reader);
/** Throws DataError where the file is too short for its pixels. The size must be a sane one. */
void checkBmp(const CheckedFile& file, const BmpHeader& header);
/** Hands out the pixels of a checked bmp, row by row; `row` counts from the lowest. Throws
 *  DataError where something follows them, or a pixel is not in the palette. */
void decodeBmp(CheckedFile& file, const BmpHeader& header,
               const std::function<void(std::size_t row, const std::vector<BmpPixel>&)>& take);

bool isJpeg(ByteView head);
/** Decodes a jpeg into one grey level per pixel, the highest row first, and gives `frame` its size;
 *  colours are averaged. Throws DataError for other colours than greys or red, green and blue, like
 *  checkPictureSize(), and for damage of any kind, be it only a warning to libjpeg. */
std::vector<std::uint8_t> decodeJpeg(ByteView jpeg, const std::string& file, GridFrame& frame);

struct PgmHeader {
  bool isText = false;
  std::uint64_t width = 0, height = 0, brightest = 0;
  std::size_t size = 0;  ///< bytes before the first pixel
};

/** Reads the size from the first bytes of a pgm (P2, P5). Throws DataError where it is damaged. */
PgmHeader readPgmHeader(ByteReader reader);
/** Throws DataError where the file is damaged, too short for its pixels, or goes on behind them, as
 *  far as that can be told without reading them. The size must be a sane one. */
void checkPgm(CheckedFile& file, const PgmHeader& header);
/** Hands out the pixels of a checked pgm as they are stored, row by row from the top; `row` counts
 *  from the lowest. Values may be above `brightest`. Throws DataError where pixels are missing or
 *  something follows them. */
void decodePgm(CheckedFile& file, const PgmHeader& header,
               const std::function<void(std::size_t row, const std::vector<std::uint32_t>&)>& take);

struct PngHeader {
  std::uint32_t width = 0, height = 0;
  int bitsPerPixel = 0, bitsPerChannel = 0;
  bool isColour = false;  ///< three colours in each pixel, and no palette
};

/** Reads the size from the first bytes of a png. */
PngHeader readPngHeader(ByteReader reader);
/** Throws DataError unless every chunk is whole, its checksum right, the last one the end of the
 *  file, and the compressed data long enough for the pixels to be in it at all; of a large picture,
 *  unless it is whole. */
void checkPng(ByteReader reader, const PngHeader& header);
/** Decodes a checked png into one grey level per pixel, the highest row first. Gamma and colour
 *  profiles are not applied, as map servers do not. */
std::vector<std::uint8_t> decodePng(ByteView png, const std::string& file);
/** Decodes a checked png into 1 for each pixel that is not opaque, else 0, the highest row
 *  first. */
std::vector<std::uint8_t> decodePngClear(ByteView png, const std::string& file);
/** Decodes a checked png into one label per pixel as readLabels() has them, the highest row first.
 *  Must not be called for colours of 16 bits per channel. */
std::vector<std::uint32_t> decodePngLabels(ByteView png, const std::string& file);

}  // namespace roomgraph
