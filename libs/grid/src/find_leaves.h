#pragma once
#include <vector>

#include "roomgraph/grid/Grid.h"

namespace roomgraph {

// In:   cells of obstacles, Grid
// Out:  the cells of leaves of open doors
// Next: clearClutter

/** The cells of the leaves of doors that stand open: what is thin and straight, ends free, hangs at
 *  a wall, and is about as long as the opening beside it in that wall is wide. Not what is in line
 *  with a wall behind a gap, as beside a doorway in a corner. All measures follow from the size of
 *  the largest clutter, `maxSize` [m]. Each cell once, in the order of rows. O(obstacles). */
std::vector<Cell> findLeaves(const std::vector<Cell>& obstacles, const Grid& grid, double maxSize);

}  // namespace roomgraph
