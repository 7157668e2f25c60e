#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "roomgraph/consensus/RunMatches.h"

namespace roomgraph {

/** What a pose graph is solved from. */
struct PoseGraph {
  const std::vector<RunSubmaps>& runs;
  const std::vector<RunMatches>& matches;
  std::vector<double> slack;             ///< of each run: how far its links give way, 1 at first
  std::vector<double> belief;            ///< of each of `matches`: how far it is taken for right
  std::optional<std::size_t> reference;  ///< the run that stays as it is
};

struct PoseGraphSolution {
  SubmapPoses poses;
  double cost = 0;
};

/** How much longer the kernels are at first. A rough start needs long ones, a good start none. */
enum class StartIs { rough, good };

/** The poses of all submaps that fit best, by robust least squares (Ceres), from `start` on:
 *  - each link keeps the pose of its submaps to each other, as far as its run's slack allows;
 *  - each match lays two submaps of different runs on each other;
 *  - the axes of each submap lie along those of the building, a weak prior.
 *  All count by kernels that let go of what contradicts the rest: a link that gives way is a break
 *  of its run. The first submap of the first run stays where it is, or all of the reference.
 *  Deterministic. About 1 s for 2500 submaps. */
PoseGraphSolution solvePoseGraph(const PoseGraph& graph, SubmapPoses start, StartIs startIs);

/** The mean squared residual of a run's links in `poses`, in units of what its links allow with
 *  a slack of 1; of the tenth that gives way most nothing is counted. */
double meanStrain(const RunSubmaps& run, const std::vector<Transform2D>& poses);

}  // namespace roomgraph
