#pragma once
#include <optional>

#include "roomgraph/geometry/Polyline.h"

namespace roomgraph {

// After the discrete Frechet distance of Eiter and Mannila (1994); laying ends on ends is ours
// In:   two paths between the same two places
// Out:  how far apart they run
// Next: compareGraphs

/** The discrete Frechet distance of two lines [m], each cut evenly into the same number of steps
 *  (about 0.25 m, at most 64), after `b` has been moved so that its ends lie as near to those of
 *  `a` as a turn and a shift allow. Where the ends of one lie close together, as those of a loop,
 *  they give no direction: then all of `b` is laid on `a` as well as possible. 0 for equal lines;
 *  the same when both are swapped or walked backwards. None where a line has no length.
 *  O(points + steps^2). */
std::optional<double> pathFrechet(const Polyline& a, const Polyline& b);

}  // namespace roomgraph
