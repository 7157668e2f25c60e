#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/grid/Grid.h"

namespace roomgraph {

// Paper III-A: "all occupied cells in the 2D grid map are used as obstacles in the Voronoi Graph"
// In:   Grid and its thinned obstacles
// Out:  ObstacleCells
// Next: voronoiGraph

/** The cells whose centres are the obstacles of the Voronoi diagram, by row, then by column.
 *  Where unknown bounds the free space they include cells of the ring just outside of the grid. */
struct ObstacleCells {
  GridFrame frame;          ///< of the grid
  std::vector<Cell> cells;  ///< by row, then by column
};

/** `isObstacle` is thinObstacles' answer for `grid`; with `ringIsObstacle`, what lies beyond the
 *  border bounds the free cells at it. O(cells). */
[[nodiscard]] ObstacleCells obstacleCells(const Grid& grid,
                                          const std::vector<std::uint8_t>& isObstacle,
                                          bool ringIsObstacle);

}  // namespace roomgraph
