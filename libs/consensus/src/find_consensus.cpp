#include "roomgraph/consensus/find_consensus.h"

#include <algorithm>
#include <cmath>

#include "pose_graph.h"
#include "start_poses.h"

namespace roomgraph {
namespace {

// The least slack of a run's links: of one that has its drive to itself, and of one that shares it.
constexpr double kLeastSlack = 0.1, kLeastSharedSlack = 0.4;
constexpr std::size_t kFewRuns = 5;
constexpr double kShared = 0.2;  // of a run's scans, to share the drive of another

std::vector<bool> shareTheirDrive(const std::vector<RunSubmaps>& runs,
                                  const std::vector<RunMatches>& matches) {
  std::vector<bool> shared(runs.size());
  for (const RunMatches& pair : matches) {
    const auto same = double(std::count_if(pair.matches.begin(), pair.matches.end(),
                                           [](const SubmapMatch& m) { return m.isSameScan; }));
    for (const std::size_t run : {pair.of, pair.in})
      if (same > kShared * double(runs[run].submaps.size())) shared[run] = true;
  }
  return shared;
}

/** Of the runs without scans, how far the links give way where they do most. */
double mostOfPatches(const std::vector<RunSubmaps>& runs, const SubmapPoses& poses) {
  double most = 0;
  for (std::size_t r = 0; r < runs.size(); ++r)
    if (!runs[r].areScans) most = std::max(most, meanStrain(runs[r], poses[r]));
  return most;
}

/** Lets the links of a run give way as far as they did (Foerstner 1979, one step). Patches hold
 *  each other many times over, so of them it counts only how runs compare. */
std::vector<double> slackOf(const std::vector<RunSubmaps>& runs,
                            const std::vector<RunMatches>& matches, const SubmapPoses& poses) {
  const std::vector<bool> shared = shareTheirDrive(runs, matches);
  const double most = mostOfPatches(runs, poses);
  std::vector<double> slack;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const double unit = !runs[r].areScans && most > 0 ? most : 1;
    slack.push_back(std::clamp(std::sqrt(meanStrain(runs[r], poses[r]) / unit),
                               shared[r] ? kLeastSharedSlack : kLeastSlack, 1.0));
  }
  return slack;
}

}  // namespace

SubmapPoses findConsensus(const std::vector<RunSubmaps>& runs,
                          const std::vector<RunMatches>& matches, const ConsensusOptions& options) {
  if (runs.empty()) return {};
  PoseGraph graph{runs, matches, std::vector<double>(runs.size(), 1.0), options.reference};
  std::vector<std::size_t> pivots;
  // Many runs need fewer: most of them are not torn where the first pivot is.
  const std::size_t most = runs.size() > kFewRuns ? options.pivots - 1 : options.pivots;
  for (std::size_t r = 0; r < std::min(std::max<std::size_t>(1, most), runs.size()); ++r)
    pivots.push_back(r);
  if (options.reference) pivots = {*options.reference};
  std::vector<PoseGraphSolution> solutions(pivots.size());
  options.forEach(pivots.size(), [&](std::size_t i) {
    solutions[i] = solvePoseGraph(graph, startPoses(runs, matches, pivots[i]), StartIs::rough);
  });
  const auto best = std::min_element(
      solutions.begin(), solutions.end(),
      [](const PoseGraphSolution& l, const PoseGraphSolution& r) { return l.cost < r.cost; });
  graph.slack = slackOf(runs, matches, best->poses);
  return solvePoseGraph(graph, best->poses, StartIs::good).poses;
}

}  // namespace roomgraph
