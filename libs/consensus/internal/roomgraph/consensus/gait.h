#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "roomgraph/align/near_poses.h"

namespace roomgraph {

// In:   where a run has drawn its scans, and when they were taken
// Out:  Gait
// Next: mendSteps, StepWitness, PoseGraph

/** How the robot goes from scan to scan, by all of its steps: but for a tear they are right. */
struct Gait {
  double back = 0;        ///< no step leads farther back [m]; at most 0
  PoseTolerance longest;  ///< no step is longer
  PoseTolerance fastest;  ///< nor faster, where scans have times [rad/s, m/s]; else 0

  /** `times` [s], as long as `poses`, run <- robot. */
  Gait(const std::vector<Transform2D>& poses, std::vector<std::optional<double>> times);

  /** How far the robot can have come to scan `k` from the one before [m]; anywhere behind a clock
   *  that was set back: that is another drive. */
  double reachTo(std::size_t k) const;

  /** Whether the robot may have gone so to scan `k`. Who has turned may come from any side. */
  bool isPossible(const Transform2D& step, std::size_t k) const;

  /** The same of a step that is only guessed: whether it has turned or not, it does not lead
   *  farther back than others do. */
  bool isLikely(const Transform2D& step, std::size_t k) const;

 private:
  /** From the scan before [s]; 0 where that is not known. */
  double secondsTo(std::size_t k) const;
  bool isInReach(const Transform2D& step, std::size_t k) const;

  std::vector<std::optional<double>> times_;
};

}  // namespace roomgraph
