#pragma once
#include <optional>

#include "ClutterGroup.h"

namespace roomgraph {

// In:   Grid, a place in what stands in it, a way
// Out:  the wall that it is in line with
// Next: furnitureAmong, findLeaves

/** Of the size of the largest clutter: how wide a gap between two pieces of one wall may be, which
 *  is that of a wide door. */
constexpr double kWidestGap = 1.5;

/** On a way [cells] that begins within something: a place in what is solid, or unseen, behind the
 *  gap beside it. None where the gap is wider than this [cells], or goes to the map's rim. */
std::optional<Point> acrossGap(const Grid& grid, Point place, Point step, double widest);

/** Whether a wall about as thick as this goes on from a place for its own thickness [cells]. */
bool wallGoesOn(const Grid& grid, Point place, Point step, double thickness);

}  // namespace roomgraph
