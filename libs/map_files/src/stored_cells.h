#pragma once
#include <charconv>
#include <cstdint>

namespace roomgraph {

/** What the writer meant where a file keeps single precision: 0.05 is stored as 0.0500000007. */
inline double decimal(float value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  double result = value;
  std::from_chars(text, end, result);
  return result;
}

/** The grey of a cell that is occupied with this probability [%], as ROS keeps its grids. */
inline std::uint8_t greyOfPercent(int percent) {
  return std::uint8_t((255 * (100 - percent) + 50) / 100);
}

}  // namespace roomgraph
