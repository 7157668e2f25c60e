#include "self_consensus.h"

#include <algorithm>
#include <set>
#include <utility>

#include "fitted_check.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/check/find_revisits.h"
#include "roomgraph/consensus/belief.h"
#include "roomgraph/consensus/solve_pose_graph.h"

namespace roomgraph {
namespace {

/** The run at other poses than it has. Where something speaks against a step, walls that turn there
 *  are turned wrongly; where nothing does they are a wing's, however little the scans say. */
PoseGraph graphAt(const Run& run, const std::vector<Transform2D>& poses,
                  const std::vector<StepEvidence>& evidence, const std::vector<Revisit>& revisits) {
  PoseGraph graph;
  const RunId id = graph.addRun(true);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const NodeId node = graph.addNode(poses[k], run.scans[k].ends, run.scans[k].axes);
    if (!evidence.empty()) graph.nodes[node].isDoubtful = speaksAgainst(evidence[k]);
    if (k > 0) graph.addLink(NodeId(k - 1), node);
  }
  for (const Revisit& revisit : revisits) graph.addGroup({id, id, {}}, revisit);
  return graph;
}

std::vector<Transform2D> solvedFrom(const PoseGraph& graph, const std::vector<Transform2D>& start,
                                    StartIs startIs) {
  GraphTrust trust{ById<RunId, double>(1, 1.0),
                   ById<MatchGroupId, double>(graph.groups.size(), 1.0)};
  NodePoses poses = solvePoseGraph(graph, trust, NodePoses(start), startIs).poses;
  trust = {runSlack(graph, poses), beliefIn(graph, poses, kInlier)};
  poses = solvePoseGraph(graph, trust, poses, StartIs::good).poses;
  return {poses.begin(), poses.end()};
}

/** The error of the run as it was drawn, and what of it was seen twice. */
MapError errorOf(const Run& run, const std::vector<Revisit>& revisits,
                 const std::vector<Transform2D>& poses) {
  MapError error =
      mapError(graphAt(run, drawnPoses(run.scans), {}, {}), RunId(0), NodePoses(poses), 1);
  for (const Revisit& revisit : revisits)
    for (const PoseEdge& edge : revisit)
      error.isSeen[edge.from.index()] = error.isSeen[edge.to.index()] = true;
  return error;
}

}  // namespace

bool isInlier(const PoseEdge& revisit, const std::vector<Transform2D>& poses) {
  const Transform2D found = poses[revisit.from.index()].inverse() * poses[revisit.to.index()];
  return areNear(revisit.measured, found, {}, kNextPatch);
}

SelfConsensus selfConsensus(const Run& run, const std::vector<LocalScan>& scans,
                            const MendedSteps& mended) {
  SelfConsensus result;
  result.poses = mended.poses;
  std::vector<Revisit> revisits;
  for (const StartIs startIs : {StartIs::rough, StartIs::good}) {
    revisits = findRevisits(scans, result.poses);
    result.poses =
        solvedFrom(graphAt(run, mended.poses, mended.evidence, revisits), result.poses, startIs);
  }
  result.error = errorOf(run, revisits, result.poses);
  for (const Revisit& revisit : revisits)
    result.revisits.insert(result.revisits.end(), revisit.begin(), revisit.end());
  const Transform2D back = result.error.pose.inverse();
  for (Transform2D& pose : result.poses) pose = back * pose;
  return result;
}

bool isConfirmed(const SelfConsensus& consensus, const std::vector<std::size_t>& breaks) {
  std::vector<std::pair<std::size_t, std::size_t>> fits;
  for (const PoseEdge& edge : consensus.revisits)
    if (isInlier(edge, consensus.poses))
      fits.push_back(std::minmax(edge.from.index(), edge.to.index()));
  const auto isSeenAcross = [&](std::size_t k) {
    std::set<std::size_t> before, behind;
    for (const auto& [earlier, later] : fits)
      if (earlier < k && k <= later) before.insert(earlier), behind.insert(later);
    return before.size() >= std::min(fitted::kLeastAcross, k) &&
           behind.size() >= std::min(fitted::kLeastAcross, consensus.poses.size() - k);
  };
  return fits.size() > fitted::kFitsPerMiss * (consensus.revisits.size() - fits.size()) &&
         allOf(breaks, isSeenAcross);
}

}  // namespace roomgraph
