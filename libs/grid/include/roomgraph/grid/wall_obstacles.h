#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/grid/Grid.h"
#include "roomgraph/grid/obstacle_cells.h"

namespace roomgraph {

// In:   Grid, ObstacleCells
// Out:  one flag per obstacle: non-zero is wall
// Next: splitAtDoors

/** Tells walls from the edge of what was seen. An obstacle is wall if a cell no further than two
 *  cells away is occupied: a rim of unknown cells in front of a wall hides none. On a map that was
 *  drawn, not seen, all obstacles are wall. Seen maps are known by their beams: of the free cells
 *  at the unknown, away from walls, a twentieth at least are in strips one or two cells wide.
 *  O(cells). */
[[nodiscard]] std::vector<std::uint8_t> wallObstacles(const Grid& grid,
                                                      const ObstacleCells& obstacles);

}  // namespace roomgraph
