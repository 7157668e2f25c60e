#pragma once
#include <optional>
#include <vector>

#include "roomgraph/breaks/MapBreak.h"
#include "roomgraph/consensus/track_scans.h"

namespace roomgraph {

// Ours
// In:   where the scans of a run lie in several other maps
// Out:  ScanBreak
// Next: compareRuns

/** Poses of a run's scans in one other map, in the order of the scans. */
using ScanTrack = std::vector<std::optional<Transform2D>>;

/** A place where a run's own poses jump. */
struct ScanBreak {
  std::size_t scan = 0;             ///< the first one behind the break
  double rotation = 0;              ///< by which the run turns its map too far from there on [rad]
  double shift = 0;                 ///< by which it moves it too far, at the robot's place [m]
  std::vector<std::size_t> seenIn;  ///< tracks that show it, ascending
};

struct FindBreaksOptions {
  double minRotation = 0.035;     ///< [rad]
  double minShift = kBreakShift;  ///< [m]
  double outlier = 4;             ///< times the 95th percentile of the run's other steps
  double quiet = 0.4;             ///< share of the jump that the steps around it may reach
  std::size_t window = 5;         ///< scans on either side that must be quiet
  std::size_t maxGap = 3;         ///< scans from one that was found to the next
  std::size_t sameScan = 1;       ///< how far apart two tracks show the same break [scans]
};

/** Where the poses of a run's scans jump against their poses in other maps, from one scan to the
 *  next, while they are steady before and after. A drift is no break. A break must show in tracks
 *  of more than half of all `weights`, as another map may be broken itself: rotation and shift are
 *  medians over these. By scan. None within two scans of either end. O(tracks * scans * window). */
std::vector<ScanBreak> findBreaks(const std::vector<ScanWalls>& scans,
                                  const std::vector<ScanTrack>& tracks,
                                  const std::vector<double>& weights,
                                  const FindBreaksOptions& options);

}  // namespace roomgraph
