#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "roomgraph/base/Options.h"
#include "roomgraph/grid/Grid.h"

namespace roomgraph {

// Paper IV-C, step 2
// In:   Grid
// Out:  the cells that stay obstacles
// Next: obstacleCells

struct ThinObstaclesOptions {
  std::string neighbours = "8";  ///< "none", "4" or "8"
  /** Whether unknown cells bound the free space as walls do. */
  bool unknownIsObstacle = true;
};
void describe(ThinObstaclesOptions& options, FieldTable& table);

/** Drops the obstacle cells whose 4 or 8 neighbours are all obstacles: they bound nothing.
 *  What lies beyond the border counts as the cell at the border. Returns one flag per cell,
 *  row-major; non-zero is an obstacle. O(cells). */
[[nodiscard]] std::vector<std::uint8_t> thinObstacles(const Grid& grid,
                                                      const ThinObstaclesOptions& options);

}  // namespace roomgraph
