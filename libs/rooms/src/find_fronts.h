#pragma once
#include <vector>

#include "RegionGroups.h"
#include "roomgraph/grid/Grid.h"

namespace roomgraph {

// In:   RegionGroups before any has joined, and the map without clutter
// Out:  the edges through the open fronts of cubicles
// Next: splitAtDoors

/** Which edges of the diagram lead through the front of a cubicle, or of a room as open as that,
 *  and at which end this lies: an opening that is wider than a door, and need not be narrow beside
 *  either of its sides. At both of its ends wall stands in line with it and nothing before that,
 *  for half of its width or until a wall goes off as far into the cubicle; along its whole depth
 *  this is longer than the opening; and before the opening is no cubicle. Of several edges through
 *  one opening the narrowest count. O(edges * width in cells + fronts^2). */
std::vector<CubicleEnd> findFronts(const RegionGroups& regions, const Grid& grid);

}  // namespace roomgraph
