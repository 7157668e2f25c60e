#include "roomgraph/consensus/find_consensus.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "belief.h"
#include "move_pieces.h"
#include "roomgraph/consensus/pose_graph.h"
#include "roomgraph/consensus/shared_drives.h"
#include "start_poses.h"
#include "whole_poses.h"

namespace roomgraph {
namespace {

// The least slack of a run's links: of one that has its drive to itself, and of one that shares it.
constexpr double kLeastSlack = 0.1, kLeastSharedSlack = 0.4;
constexpr std::size_t kFewRuns = 5;
constexpr double kAboutAsGood = 1.25;  // cost beside that of the best

std::vector<bool> shareTheirDrive(const std::vector<RunSubmaps>& runs,
                                  const std::vector<RunMatches>& matches) {
  std::vector<bool> shared(runs.size());
  for (const RunMatches& pair : matches) {
    const auto same = double(std::count_if(pair.matches.begin(), pair.matches.end(),
                                           [](const SubmapMatch& m) { return m.isSameScan; }));
    for (const std::size_t run : {pair.of, pair.in})
      if (same > kSharedDrive * double(runs[run].submaps.size())) shared[run] = true;
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

PoseGraphSolution solvedFrom(PoseGraph& graph, SubmapPoses start) {
  graph.belief = beliefIn(graph.matches, start, kRoughly);
  PoseGraphSolution solution = solvePoseGraph(graph, std::move(start), StartIs::rough);
  movePieces(graph, solution.poses);
  graph.belief = beliefIn(graph.matches, solution.poses, kBorneOut);
  solution = solvePoseGraph(graph, std::move(solution.poses), StartIs::good);
  solution.cost += costOfDisbelief(graph.matches, graph.belief);
  return solution;
}

/** Where the search begins: where no run is torn, and in the frames of some runs, the pivots. Of
 *  many runs one is enough: most of them are not torn where it is. */
std::vector<SubmapPoses> startsOf(const std::vector<RunSubmaps>& runs,
                                  const std::vector<RunMatches>& matches,
                                  const ConsensusOptions& options) {
  std::vector<SubmapPoses> starts{wholePoses(runs, matches, options.reference)};
  if (options.reference) {
    starts.push_back(startPoses(runs, matches, *options.reference));
    return starts;
  }
  const std::size_t most = runs.size() > kFewRuns ? 1 : std::max<std::size_t>(1, options.pivots);
  for (std::size_t pivot = 0; pivot < std::min(most, runs.size()); ++pivot)
    starts.push_back(startPoses(runs, matches, pivot));
  return starts;
}

}  // namespace

ConsensusPoses findConsensus(const std::vector<RunSubmaps>& runs,
                             const std::vector<RunMatches>& matches,
                             const ConsensusOptions& options) {
  if (runs.empty()) return {};
  std::vector<SubmapPoses> starts = startsOf(runs, matches, options);
  const std::vector<double> slack(runs.size(), 1.0);
  std::vector<PoseGraph> graphs(starts.size(), {runs, matches, slack, {}, options.reference});
  std::vector<PoseGraphSolution> solutions(starts.size());
  options.forEach(starts.size(), [&](std::size_t i) {
    solutions[i] = solvedFrom(graphs[i], std::move(starts[i]));
  });
  const auto best = std::min_element(
      solutions.begin(), solutions.end(),
      [](const PoseGraphSolution& l, const PoseGraphSolution& r) { return l.cost < r.cost; });
  PoseGraph graph = graphs[std::size_t(best - solutions.begin())];
  graph.slack = slackOf(runs, matches, best->poses);
  ConsensusPoses result{solvePoseGraph(graph, best->poses, StartIs::good).poses, {}};
  for (auto other = solutions.begin(); other != solutions.end(); ++other)
    if (other != best && other->cost <= kAboutAsGood * best->cost)
      result.others.push_back(std::move(other->poses));
  return result;
}

}  // namespace roomgraph
