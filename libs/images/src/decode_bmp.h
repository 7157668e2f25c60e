#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "roomgraph/base/checked_file.h"

namespace roomgraph {

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
BmpHeader readBmpHeader(ByteReader in);
/** Throws DataError where the file is too short for its pixels. The size must be a sane one. */
void checkBmp(const CheckedFile& file, const BmpHeader& header);
/** Hands out the pixels of a checked bmp, row by row; `row` counts from the lowest. Throws
 *  DataError where something follows them, or a pixel is not in the palette. */
void decodeBmp(CheckedFile& file, const BmpHeader& header,
               const std::function<void(std::size_t row, const std::vector<BmpPixel>&)>& take);

}  // namespace roomgraph
