#include "roomgraph/grid/CellBox.h"

namespace roomgraph {

CellBox knownCells(const Grid& grid) {
  CellBox box;
  for (int y = 0; y < grid.frame.height; ++y)
    for (int x = 0; x < grid.frame.width; ++x)
      if (grid.at({x, y}) != State::unknown) box.include({x, y});
  return box;
}

}  // namespace roomgraph
