#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "roomgraph/images/Colour.h"

namespace roomgraph {

/** A picture of few colours, one palette index for each pixel. */
struct PaletteImage {
  int width = 0, height = 0;
  std::vector<Colour> palette;        ///< at most 16
  std::vector<std::uint8_t> indices;  ///< row-major, row 0 lowest
  std::vector<std::uint8_t> alphas;   ///< of the first colours; the others are opaque
};

/** What each PNG file says of its author, as its text "Software" in front of the pixels: whoever
 *  finds none has a picture that is somebody else's. */
constexpr char kPngSoftware[] = "roomgraph";

/** PNG file with two bits for each pixel, or four where there are more than four colours. Where
 *  there are alphas the file is packed well rather than fast. */
std::string pngBytes(const PaletteImage& image);

/** PNG file of opaque pixels, as cairo holds them: one 32 bit word 0xXXRRGGBB each, `stride` bytes
 *  from row to row, row 0 on top. Fast rather than small. */
std::string pngBytes(const unsigned char* pixels, int width, int height, int stride);

/** PNG file with 8 bits of grey for each pixel, or 16; `levels` are row-major, row 0 lowest. */
std::string pngBytes(const std::vector<std::uint8_t>& levels, int width, int height);
std::string pngBytes(const std::vector<std::uint16_t>& levels, int width, int height);

/** PGM file with 8 bits of grey for each pixel; `levels` are row-major, row 0 lowest. */
std::string pgmBytes(const std::vector<std::uint8_t>& levels, int width, int height);

}  // namespace roomgraph
