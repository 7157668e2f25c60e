#pragma once
#include <cstdint>

namespace roomgraph {

/** The grey of a cell that is occupied with this probability [%], as ROS keeps its grids. */
inline std::uint8_t greyOfPercent(int percent) {
  return std::uint8_t((255 * (100 - percent) + 50) / 100);
}

}  // namespace roomgraph
