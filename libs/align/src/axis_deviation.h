#pragma once
#include <optional>
#include <vector>

#include "roomgraph/align/WallPoint.h"

namespace roomgraph {

// Ours: what a map tells of itself, without any other
// In:   the walls of a map
// Out:  how far its walls are from right angles
// Next: siteConsensus

/** The median angle between the walls of a map and the nearer of its two main directions, which are
 *  at right angles [rad]. Every pose error turns some walls, so of several maps of one building the
 *  most rectangular one bends least; of different buildings it says nothing. Each wall point takes
 *  its direction from those within 1.5 m that face the same way; places that are not straight do
 *  not count. None where fewer than 100 points do. O(walls * walls within 1.5 m). */
std::optional<double> axisDeviation(const std::vector<WallPoint>& walls);

}  // namespace roomgraph
