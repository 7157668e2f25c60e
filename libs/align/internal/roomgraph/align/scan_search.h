#pragma once
#include <cstddef>

#include "roomgraph/align/NarrowingBand.h"
#include "roomgraph/align/nearest_wall.h"

namespace roomgraph {

// The search for a scan in a map, or in another scan.
constexpr NarrowingBand kScanBand{0.6, kSameWall, 7};
constexpr double kHalfNear = 0.1;   // a wall this far from another counts half [m]
constexpr double kRoughNear = 0.3;  // the same in the search, in steps of as much
constexpr std::size_t kRoughWalls = 30;
constexpr std::size_t kTries = 6;  // poses of the search that are looked at closely

}  // namespace roomgraph
