#include "roomgraph/consensus/find_consensus.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "belief.h"
#include "coarse_graph.h"
#include "fitted_consensus.h"
#include "move_pieces.h"
#include "roomgraph/consensus/pose_graph.h"
#include "roomgraph/relate/shares_drive.h"
#include "start_poses.h"
#include "whole_poses.h"

namespace roomgraph {
namespace {

constexpr std::size_t kFewRuns = 5;

/** Of each run, whether it shares its drive with another one. */
std::vector<bool> haveSharedDrives(const std::vector<RunSubmaps>& runs,
                                   const std::vector<RunMatches>& matches) {
  std::vector<bool> isShared(runs.size());
  for (const RunMatches& piece : matches) {
    const auto same = std::count_if(piece.matches.begin(), piece.matches.end(),
                                    [](const SubmapMatch& match) { return match.isSameScan; });
    for (const std::size_t run : {piece.of, piece.in})
      if (sharesDrive(std::size_t(same), runs[run].submaps.size())) isShared[run] = true;
  }
  return isShared;
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
  const std::vector<bool> isShared = haveSharedDrives(runs, matches);
  const double most = mostOfPatches(runs, poses);
  std::vector<double> slack;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const double unit = !runs[r].areScans && most > 0 ? most : 1;
    slack.push_back(std::clamp(std::sqrt(meanStrain(runs[r], poses[r]) / unit),
                               isShared[r] ? fitted::kLeastSharedSlack : fitted::kLeastSlack, 1.0));
  }
  return slack;
}

/** As a run has drawn them. */
SubmapPoses ownPoses(const std::vector<RunSubmaps>& runs) {
  SubmapPoses poses(runs.size());
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (const Submap& submap : runs[r].submaps) poses[r].push_back(submap.pose);
  return poses;
}

/** The coarse form of a graph of many runs. With few runs each key frame tells. */
std::optional<CoarseGraph> coarseOfMany(const PoseGraph& graph) {
  if (graph.runs.size() <= kFewRuns) return std::nullopt;
  return coarseGraph(graph.runs, graph.matches);
}

/** Solves a graph by its coarse form; submaps keep their `shape` within a coarse one. */
SubmapPoses solvedCoarsely(const PoseGraph& graph, const CoarseGraph& coarse,
                           const SubmapPoses& shape, const SubmapPoses& start, StartIs startIs) {
  const PoseGraph rough{coarse.runs, coarse.matches, graph.slack, graph.belief, graph.reference};
  SubmapPoses poses =
      finePoses(coarse, shape, solvePoseGraph(rough, coarsePoses(coarse, start), startIs).poses);
  if (graph.reference) poses[*graph.reference] = start[*graph.reference];  // to the last bit
  return poses;
}

PoseGraphSolution solvedFrom(PoseGraph& graph, const std::optional<CoarseGraph>& coarse,
                             const SubmapPoses& start) {
  graph.belief = beliefIn(graph.matches, start, kRoughly);
  SubmapPoses poses =
      coarse ? solvedCoarsely(graph, *coarse, ownPoses(graph.runs), start, StartIs::rough)
             : solvePoseGraph(graph, start, StartIs::rough).poses;
  movePieces(graph, poses);
  graph.belief = beliefIn(graph.matches, poses, kBorneOut);
  PoseGraphSolution solution = solvePoseGraph(graph, std::move(poses), StartIs::good);
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
  const std::optional<CoarseGraph> coarse = coarseOfMany(graphs.front());
  options.forEach(starts.size(),
                  [&](std::size_t i) { solutions[i] = solvedFrom(graphs[i], coarse, starts[i]); });
  const auto best = std::min_element(
      solutions.begin(), solutions.end(),
      [](const PoseGraphSolution& l, const PoseGraphSolution& r) { return l.cost < r.cost; });
  PoseGraph graph = graphs[std::size_t(best - solutions.begin())];
  graph.slack = slackOf(runs, matches, best->poses);
  SubmapPoses start = best->poses;
  if (coarse) start = solvedCoarsely(graph, *coarse, start, start, StartIs::good);
  ConsensusPoses result{solvePoseGraph(graph, std::move(start), StartIs::good).poses, {}};
  for (auto other = solutions.begin(); other != solutions.end(); ++other)
    if (other != best && other->cost <= fitted::kAboutAsGood * best->cost)
      result.others.push_back(std::move(other->poses));
  return result;
}

}  // namespace roomgraph
