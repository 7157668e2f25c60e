#pragma once
#include <vector>

#include "roomgraph/grid/ObstacleRows.h"
#include "roomgraph/topology/Path.h"

namespace roomgraph {

/** The points of a path that suffice to drive it in straight pieces: its ends and its bends, as
 *  places in `path.points`, ascending (Douglas and Peucker). No point that is left out is farther
 *  from its piece than half of the path's clearance, nor than 0.1 m, so the pieces keep at least
 *  half of the clearance; and none comes nearer to an obstacle than `clearance` [m], which is that
 *  of all paths. A path back to its start keeps two bends at least, so that it stays one.
 *  O(n log n) as a rule, O(n^2) at worst, and the obstacles near each piece. */
std::vector<std::size_t> straightPieces(const Path& path, const ObstacleRows& obstacles,
                                        double clearance);

}  // namespace roomgraph
