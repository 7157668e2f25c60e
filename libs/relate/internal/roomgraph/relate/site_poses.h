#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/base/PairTable.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/relate/turn_lever.h"

namespace roomgraph {

// Ours: a pose graph over the runs of a site
// In:   the alignments of all pairs
// Out:  one pose per run, all in one frame
// Next: the measures, which need all runs in the site's frame

/** What one pair of runs a and b says. */
struct PairPose {
  Transform2D pose;       ///< a <- b
  double confidence = 0;  ///< 0 to 1
  Point middle;           ///< of b's walls [m, frame of b]: where the pose is known best
};

/** Those of the pairs that join the runs of a site, each to all others over one or more. */
using PairPoses = PairTable<PairPose>;

constexpr double kMaxMisfit = 0.5;  ///< a pair that disagrees by more counts little [m]

/** Makes the poses of all pairs agree: site <- run, of each. The site's frame is that of run
 *  `reference`. First a tree of the most trusted pairs, where a pair that closes triangles with
 *  others is trusted more; then Gauss-Newton with weights that fall with the misfit, so one wrong
 *  pair among several moves nothing. With two runs: the pair's pose. Ties by the order of the
 *  pairs. O(runs^3) a step, at most 50 steps. */
std::vector<Transform2D> sitePoses(const PairPoses& pairs, std::size_t reference);

}  // namespace roomgraph
