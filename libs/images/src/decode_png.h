#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "roomgraph/base/byte_reader.h"

namespace roomgraph {

struct PngHeader {
  std::uint32_t width = 0, height = 0;
  int bitsPerPixel = 0, bitsPerChannel = 0;
  bool isColour = false;      ///< three colours in each pixel, and no palette
  bool isInterlaced = false;  ///< rows come in seven pieces
};

/** Reads the size from the first bytes of a png. */
PngHeader readPngHeader(ByteReader in);
/** Throws DataError unless every chunk is whole, its checksum right, the last one the end of the
 *  file, and the compressed data long enough for the pixels to be in it at all; of a large picture,
 *  unless it is whole. */
void checkPng(ByteReader in, const PngHeader& header);
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
