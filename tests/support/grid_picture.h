#pragma once
#include <string>

#include "roomgraph/grid/Grid.h"

namespace roomgraph::test {

/** A map as a grey picture (pgm), as map_saver of ROS writes it: what is free is white. */
inline std::string gridPicture(const Grid& grid) {
  std::string text =
      "P5 " + std::to_string(grid.frame.width) + ' ' + std::to_string(grid.frame.height) + " 255\n";
  for (int y = grid.frame.height - 1; y >= 0; --y)
    for (int x = 0; x < grid.frame.width; ++x) {
      const State state = grid.at({x, y});
      text += state == State::free ? char(254) : state == State::occupied ? char(0) : char(205);
    }
  return text;
}

}  // namespace roomgraph::test
