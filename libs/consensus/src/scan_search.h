#pragma once
#include <cstddef>

namespace roomgraph {

// The search for a scan in a map, by find_scan and by track_scans.
constexpr double kHalfNear = 0.1;   // a wall this far from another counts half [m]
constexpr double kRoughNear = 0.3;  // the same in the search
constexpr std::size_t kRoughWalls = 30;
constexpr double kDoubt = 5;       // walls that speak against each pose beforehand
constexpr std::size_t kTries = 6;  // poses of the search that are looked at closely

}  // namespace roomgraph
