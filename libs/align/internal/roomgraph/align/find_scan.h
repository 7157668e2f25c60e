#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "roomgraph/align/NarrowingBand.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/align/scan_map.h"
#include "roomgraph/align/scan_walls.h"
#include "roomgraph/align/wall_share.h"

namespace roomgraph {

// Ours; the search over all poses in a window after Olson (2009), "correlative scan matching"
// In:   a scan, and the map that other scans have drawn
// Out:  where it lies there
// Next: followWalls, mendSteps, findRevisits

/** Of the score of one fit, from which on another one is about as good. */
constexpr double kRivalScore = 0.85;

/** How well a scan fits into a map at a pose. */
struct ScanFit {
  Transform2D pose;    ///< map <- robot
  double quality = 0;  ///< share of its walls found, of those whose place the map knows; 0 to 1
  /** How much speaks for the pose: walls found, less half of those that should have been. */
  double score = 0;
  double known = 0;  ///< share of its walls whose place the map knows, 0 to 1
  /** How firmly the walls hold it in the direction in which they do least: 0 for a corridor without
   *  an end, 0.5 for walls that face all ways. */
  double hold = 0;
};

/** The fit at a pose as it is. O(walls). */
ScanFit fitAt(const LocalScan& scan, const WallMap& in, const Transform2D& pose);

/** The fit at the pose that a few steps from `start` come to. O(walls). */
ScanFit fitNear(const LocalScan& scan, const WallMap& in, const Transform2D& start);

/** The best fits with poses within a window around `around`, the best first, each not kSameAnswer
 *  to a better one, at most `count`. O(poses in the window * some walls). */
std::vector<ScanFit> findScan(const LocalScan& scan, const WallMap& in, const Transform2D& around,
                              const PoseTolerance& window, std::size_t count);

/** The fit of the highest score; the end of none. O(fits). */
inline std::vector<ScanFit>::const_iterator bestOf(const std::vector<ScanFit>& fits) {
  return std::max_element(fits.begin(), fits.end(),
                          [](const ScanFit& l, const ScanFit& r) { return l.score < r.score; });
}

// The search for a scan in a map, or in another scan, as `benchmarks/score_accuracy` judges it.
constexpr NarrowingBand kScanBand{0.6, kSameWall, 7};
constexpr std::size_t kTries = 6;  // poses of the search that are looked at closely

/** Every so manyth wall of a scan tells roughly how well a pose fits: every kQuickStrideth of one
 *  with many, and more of the walls of others. */
inline std::size_t roughStride(std::size_t walls) {
  return std::max<std::size_t>(1, walls * kQuickStride / std::size_t(kWallsPerScan));
}

}  // namespace roomgraph
