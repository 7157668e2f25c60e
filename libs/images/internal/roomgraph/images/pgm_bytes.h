#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace roomgraph {

/** PGM file with 8 bits of grey for each pixel; `levels` are row-major, row 0 on top. */
inline std::string pgmBytes(const std::vector<std::uint8_t>& levels, int width, int height) {
  return "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n" +
         std::string(levels.begin(), levels.end());
}

}  // namespace roomgraph
