#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/relate/turn_lever.h"

namespace roomgraph {

// Ours: a pose graph over the runs of a site
// In:   the alignments of all pairs
// Out:  one pose per run, all in one frame
// Next: the measures, which need all runs in the site's frame

/** What one pair says. */
struct PairPose {
  std::size_t a = 0, b = 0;  ///< indices of the runs, a != b
  Transform2D pose;          ///< a <- b
  double confidence = 0;     ///< 0 to 1
  Point middle;              ///< of b's walls [m, frame of b]: where the pose is known best
};

constexpr double kMinPairConfidence = 0.3;  ///< pairs below this are not used
constexpr double kMaxMisfit = 0.5;          ///< a pair that disagrees by more counts little [m]

struct SitePose {
  Transform2D pose;       ///< site <- run
  bool isPlaced = false;  ///< joined to the first run by pairs that agree; else `pose` is nothing
};

struct SitePoses {
  std::vector<SitePose> runs;  ///< one per run
  std::vector<double> misfit;  ///< of each pair against these poses [m]; of unplaced runs: 0
};

/** Makes the poses of all pairs agree. The site's frame is that of run `reference`. First a tree of
 *  the most trusted pairs, where a pair that closes triangles with others is trusted more; then
 *  Gauss-Newton with weights that fall with the misfit, so one wrong pair among several moves
 *  nothing. With two runs: the pair's pose. A run that no used pair joins to the reference is not
 *  placed. Ties by the order of the pairs. O(runs^3) a step, at most 50 steps.
 *  @throws UsageError where a pair names a run that is not there, or `reference` is none. */
SitePoses sitePoses(std::size_t runs, const std::vector<PairPose>& pairs, std::size_t reference);

}  // namespace roomgraph
