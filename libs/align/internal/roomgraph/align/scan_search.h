#pragma once
#include <algorithm>
#include <cstddef>

#include "roomgraph/align/NarrowingBand.h"
#include "roomgraph/align/scan_walls.h"
#include "roomgraph/align/wall_share.h"

namespace roomgraph {

// The search for a scan in a map, or in another scan.
constexpr NarrowingBand kScanBand{0.6, kSameWall, 7};
constexpr double kHalfNear = 0.1;   // a wall this far from another counts half [m]
constexpr double kRoughNear = 0.3;  // the same in the search, in steps of as much
constexpr std::size_t kTries = 6;   // poses of the search that are looked at closely

/** Every so manyth wall of a scan tells roughly how well a pose fits: every kQuickStrideth of one
 *  with many, and more of the walls of others. */
inline std::size_t roughStride(std::size_t walls) {
  return std::max<std::size_t>(1, walls * kQuickStride / std::size_t(kWallsPerScan));
}

}  // namespace roomgraph
