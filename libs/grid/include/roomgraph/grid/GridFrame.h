#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** A cell by column and row; row 0 is the lowest (smallest y). */
struct Cell {
  int x = 0, y = 0;  ///< column and row, from 0 at the lower left
};

/** So far off lies no map that is read, and nothing that is marked on one [m]. */
constexpr double kFarthestOrigin = 1e7;
/** Sides of cells that maps may have [m]. */
constexpr double kSmallestCell = 1e-4, kLargestCell = 1e3;

/** How the cells of a grid lie in the map frame: the only place that knows cells and metres. */
struct GridFrame {
  int width = 0, height = 0;  ///< cells
  double resolution = 0;      ///< side of a cell [m]
  Point origin;               ///< outer corner of cell (0, 0): smallest x and y of the map [m]

  [[nodiscard]] std::size_t cellCount() const { return std::size_t(width) * std::size_t(height); }
  [[nodiscard]] bool contains(Cell c) const {
    return c.x >= 0 && c.y >= 0 && c.x < width && c.y < height;
  }
  /** Row-major index; the cell must be contained. */
  [[nodiscard]] std::size_t index(Cell c) const {
    return std::size_t(c.y) * std::size_t(width) + std::size_t(c.x);
  }
  [[nodiscard]] Point center(Cell c) const {
    return {origin.x + (c.x + 0.5) * resolution, origin.y + (c.y + 0.5) * resolution};
  }
  /** The cell that holds `p`, which may lie outside of the grid. A point far outside of it (or NaN)
   *  gives a cell outside of it. */
  [[nodiscard]] Cell cellAt(Point p) const;
  /** Whether cells and origin are within the bounds above. */
  [[nodiscard]] bool isSane() const;
  /** The cells of which `isWanted`, row by row. */
  template <class IsWanted>
  [[nodiscard]] std::vector<Cell> cellsWhere(const IsWanted& isWanted) const {
    std::vector<Cell> cells;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (isWanted(Cell{x, y})) cells.push_back({x, y});
    return cells;
  }
};

}  // namespace roomgraph
