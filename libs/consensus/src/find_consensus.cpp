#include "roomgraph/consensus/find_consensus.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "move_pieces.h"
#include "pose_graph.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/consensus/shared_drives.h"
#include "start_poses.h"

namespace roomgraph {
namespace {

// The least slack of a run's links: of one that has its drive to itself, and of one that shares it.
constexpr double kLeastSlack = 0.1, kLeastSharedSlack = 0.4;
constexpr std::size_t kFewRuns = 5;
// A match is borne out where the poses agree with it within this: before solving, and after.
constexpr PoseTolerance kRoughly{0.35, 3.0}, kBorneOut{0.15, 1.0};
constexpr double kLeastBelief = 1e-3;
constexpr double kGivenUp = 45;  // half the robust squared residual of a link that is 20 m off
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

/** How far each piece is believed: by the share of its matches that `poses` bear out. In a building
 *  that repeats itself a run is found in the wrong wing as a whole, which is one mistake, however
 *  many scans it has. What both runs have scanned as one is the same place. */
std::vector<double> beliefIn(const std::vector<RunMatches>& matches, const SubmapPoses& poses,
                             const PoseTolerance& within) {
  std::vector<double> belief;
  for (const RunMatches& piece : matches) {
    double borneOut = 0;
    for (const SubmapMatch& match : piece.matches)
      borneOut += match.isSameScan ||
                  areNear(poses[piece.in][match.in].inverse() * poses[piece.of][match.submap],
                          match.pose, {}, within);
    const double share = borneOut / double(piece.matches.size());
    belief.push_back(std::max(kLeastBelief, share * share));
  }
  return belief;
}

/** What giving up pieces costs: as much as a link that gives way. */
double costOfDisbelief(const std::vector<double>& belief) {
  double cost = 0;
  for (const double b : belief) cost += kGivenUp * (1 - b);
  return cost;
}

PoseGraphSolution solvedFrom(PoseGraph& graph, SubmapPoses start) {
  graph.belief = beliefIn(graph.matches, start, kRoughly);
  PoseGraphSolution solution = solvePoseGraph(graph, std::move(start), StartIs::rough);
  graph.belief = beliefIn(graph.matches, solution.poses, kBorneOut);
  movePieces(graph, solution.poses);
  solution = solvePoseGraph(graph, std::move(solution.poses), StartIs::good);
  solution.cost += costOfDisbelief(graph.belief);
  return solution;
}

/** The runs from whose frames the consensus is looked for. Many runs need fewer: most of them are
 *  not torn where the first pivot is. */
std::vector<std::size_t> pivotsOf(std::size_t runs, const ConsensusOptions& options) {
  if (options.reference) return {*options.reference};
  const std::size_t most = runs > kFewRuns ? options.pivots - 1 : options.pivots;
  std::vector<std::size_t> pivots(std::min(std::max<std::size_t>(1, most), runs));
  std::iota(pivots.begin(), pivots.end(), 0);
  return pivots;
}

}  // namespace

ConsensusPoses findConsensus(const std::vector<RunSubmaps>& runs,
                             const std::vector<RunMatches>& matches,
                             const ConsensusOptions& options) {
  if (runs.empty()) return {};
  const std::vector<std::size_t> pivots = pivotsOf(runs.size(), options);
  const std::vector<double> slack(runs.size(), 1.0);
  std::vector<PoseGraph> graphs(pivots.size(), {runs, matches, slack, {}, options.reference});
  std::vector<PoseGraphSolution> solutions(pivots.size());
  options.forEach(pivots.size(), [&](std::size_t i) {
    solutions[i] = solvedFrom(graphs[i], startPoses(runs, matches, pivots[i]));
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
