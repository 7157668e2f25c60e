#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "roomgraph/align/LocalScan.h"
#include "roomgraph/align/near_poses.h"

namespace roomgraph {

// Ours
// In:   the scans of a run, and where the run has drawn them
// Out:  Gait
// Next: mendSteps

/** How the robot goes from scan to scan, by all of its steps: but for a tear they are right. */
struct Gait {
  double back = 0;        ///< no step leads farther back [m]; at most 0
  PoseTolerance longest;  ///< no step is longer
  double speed = 0;       ///< nor faster, where scans have times [m/s]; else 0

  Gait(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& poses);

  /** From the scan before; 0 where that is not known. Negative behind a clock that was set back. */
  static double secondsTo(const std::vector<LocalScan>& scans, std::size_t k);

  /** Whether the robot may have gone so in so many seconds; anywhere, if these are negative: that
   *  is another drive. Who has turned may come from any side. */
  bool isPossible(const Transform2D& step, double seconds) const;

  /** The same of a step that is only guessed: whether it has turned or not, it does not lead
   *  farther back than others do. */
  bool isLikely(const Transform2D& step, double seconds) const;

 private:
  bool isInReach(const Transform2D& step, double seconds) const;
  double reachIn(double seconds) const { return std::max(longest.place, seconds * speed); }
};

}  // namespace roomgraph
