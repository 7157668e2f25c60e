#pragma once
#include <algorithm>
#include <climits>

#include "roomgraph/grid/Grid.h"

namespace roomgraph {

/** An upright box of cells; as it is made, it holds nothing. */
struct CellBox {
  Cell low{INT_MAX, INT_MAX}, high{INT_MIN, INT_MIN};  ///< the corners' cells, which are in it

  [[nodiscard]] bool isEmpty() const { return low.x > high.x; }
  /** Columns and rows; it must hold something. */
  [[nodiscard]] int width() const { return high.x - low.x + 1; }
  [[nodiscard]] int height() const { return high.y - low.y + 1; }
  [[nodiscard]] bool contains(Cell c) const {
    return c.x >= low.x && c.x <= high.x && c.y >= low.y && c.y <= high.y;
  }
  /** Grows so that it holds `c` as well. */
  void include(Cell c) {
    low = {std::min(low.x, c.x), std::min(low.y, c.y)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y)};
  }
};

/** The smallest box round the cells that are not unknown; empty for none. O(cells). */
[[nodiscard]] CellBox knownCells(const Grid& grid);

}  // namespace roomgraph
