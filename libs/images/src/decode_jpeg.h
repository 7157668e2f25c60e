#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "roomgraph/base/byte_reader.h"

namespace roomgraph {

struct JpegHeader {
  std::uint32_t width = 0, height = 0;
};

bool isJpeg(ByteView head);
/** Reads the size of a jpeg. Throws DataError where it is damaged, or has other colours than greys
 *  or red, green and blue. */
JpegHeader readJpegHeader(ByteView jpeg, const std::string& file);
/** Decodes a jpeg of sane size into one grey level per pixel, the highest row first; colours are
 *  averaged. Throws DataError for damage of any kind, be it only a warning to libjpeg. */
std::vector<std::uint8_t> decodeJpeg(ByteView jpeg, const std::string& file);

}  // namespace roomgraph
