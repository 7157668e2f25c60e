#pragma once
#include "roomgraph/grid/Grid.h"

namespace roomgraph {

// In:   an opening, and the map without clutter
// Out:  whether its wall goes on beside it, and whether it is in a corridor's side, or across one
// Next: findFronts, splitAtDoors, passageEvidence

/** Whether none of so many places is free, from the next one on in steps. O(count). */
bool isNowhereFree(const Grid& grid, Point start, Point step, int count);

/** How many steps [cells] one gets through free space, to half a one: from the border of two cells
 *  half of them lie on either side. O(that). */
double freeRun(const Grid& grid, Point start, Point step);

/** Whether wall, or what nobody has seen, goes on beyond `end` in line with an opening that ends
 *  there, for half of the opening's width. O(width in cells). */
bool goesOn(const Grid& grid, Point end, Point other);

/** Whether most of what lies there is wall, to a cell on either side, and no block: at the end of
 *  it thinner than the opening is wide. O(width in cells). */
bool isMostlyWall(const Grid& grid, Point end, Point other);

/** Whether an opening between two places is in a wall. */
using WallTest = bool(const Grid& grid, Point from, Point to);

/** Whether both are so at both ends. */
bool isInWall(const Grid& grid, Point from, Point to);

/** The same, but the wall goes on to a cell on either side, as far as the ends are known: a thin
 *  one that is turned or ragged leaves the line of its opening. */
bool isInRoughWall(const Grid& grid, Point from, Point to);

/** Whether an opening is in the side of a corridor: through its middle, and beside the wall half as
 *  deep, the free space on one of its sides is `elongation` times as long as deep, and longer than
 *  that on the other is deep. O(length in cells). */
bool isInLongSide(const Grid& grid, Point from, Point to, double elongation);

/** Whether what lies on both sides of an opening is about as wide, there, as a corridor is on both
 *  sides of a door in it. O(length in cells). */
bool isAcrossOneWidth(const Grid& grid, Point from, Point to);

}  // namespace roomgraph
