#pragma once
#include <vector>

#include "ClutterGroup.h"
#include "roomgraph/grid/Grid.h"

namespace roomgraph {

// In:   groups of cells, Grid
// Out:  those that are furniture
// Next: clearClutter

/** Nothing larger than this many times the largest clutter is furniture. */
constexpr double kLongestFurniture = 5;

/** Those of some groups that are furniture: solid, thicker than a wall, with space for a robot all
 *  round, and not in line with a wall that goes on, as the pier between two doors is. All measures
 *  follow from the size of the largest clutter, `maxSize` [m]. `groups` must be whole, and stand in
 *  the grid. O(cells of the groups and of the space round them). */
std::vector<ClutterGroup> furnitureAmong(std::vector<ClutterGroup> groups, const Grid& grid,
                                         double maxSize);

}  // namespace roomgraph
