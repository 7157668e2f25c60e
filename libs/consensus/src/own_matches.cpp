#include "own_matches.h"

#include <algorithm>

#include "fitted_consensus.h"
#include "roomgraph/align/LocalScan.h"
#include "roomgraph/align/step_hold.h"
#include "roomgraph/consensus/belief.h"
#include "roomgraph/consensus/mend_steps.h"

namespace roomgraph {
namespace {

bool isWrong(StepEvidence step) {
  return step == StepEvidence::contradicts || step == StepEvidence::lost;
}

/** Whether the step to a scan is broken. Where one step after the other is wrong, the robot was in
 *  a lift, or its scanner covered. */
bool isBroken(const std::vector<StepEvidence>& steps, std::size_t k) {
  if (steps[k] != StepEvidence::contradicts) return false;
  constexpr auto kNear = std::size_t(fitted::kLeastLostOnEnd);
  const auto first = steps.begin() + std::ptrdiff_t(k - std::min(k, kNear - 1));
  const auto end = steps.begin() + std::ptrdiff_t(std::min(steps.size(), k + kNear));
  return std::count_if(first, end, isWrong) == 1;
}

/** The scans from `k` on, as they lie in the one before it. */
FoundGroup foundBehind(const IdRange<NodeId>& nodes, RunId id, const MendedSteps& mended,
                       std::size_t k) {
  FoundGroup found{{id, id, {}}, {}};
  const std::size_t end = std::min(nodes.size(), k + fitted::kLongScans);
  for (std::size_t i = k; i < end; ++i) {
    if (i > k && isWrong(mended.evidence[i])) break;
    const Transform2D measured = mended.poses[k - 1].inverse() * mended.poses[i];
    found.matches.push_back(matchEdge(nodes[k - 1], nodes[i], measured, 1));
  }
  return found;
}

std::vector<PoseEdgeId> heldBy(const Run& run, const GraphRun& nodes, const Consensus& consensus) {
  std::vector<PoseEdgeId> held;
  std::vector<LocalScan> scans;
  std::vector<Transform2D> drawn;
  for (const PoseEdgeId id : nodes.links) {
    const PoseEdge& link = consensus.graph.edges[id];
    if (link.share > 1 || isInlier(link, gapOf(link, consensus.poses), kInlier)) continue;
    if (scans.empty()) scans = localScans(run.scans), drawn = drawnPoses(run.scans);
    const Transform2D step = consensus.poses[link.from].inverse() * consensus.poses[link.to];
    if (isRefuted(scans, drawn, nodes.nodes.placeOf(link.to), step)) held.push_back(id);
  }
  return held;
}

}  // namespace

std::vector<bool> barelyHeldSteps(const Run& run) {
  std::vector<bool> asked(run.scans.size());
  for (std::size_t k = 1; k < asked.size(); ++k) asked[k] = stepHold(run.scans, k) < 1;
  return asked;
}

std::vector<bool> stepsToUnconfirmed(const IdRange<NodeId>& nodes,
                                     const ById<NodeId, bool>& isConfirmed) {
  std::vector<bool> asked(nodes.size());
  for (std::size_t k = 1; k < asked.size(); ++k) {
    if (isConfirmed[nodes[k - 1]] == isConfirmed[nodes[k]]) continue;
    const std::size_t end = std::min(asked.size(), k + 2);  // a scan beside it may fit by chance
    std::fill(asked.begin() + std::ptrdiff_t(std::max<std::size_t>(2, k) - 1),
              asked.begin() + std::ptrdiff_t(end), true);
  }
  return asked;
}

std::vector<FoundGroup> ownMatches(const PoseGraph& graph, RunId id, const Run& run,
                                   const std::vector<bool>& asked) {
  if (std::find(asked.begin(), asked.end(), true) == asked.end()) return {};
  const MendedSteps mended = mendSteps(localScans(run.scans), drawnPoses(run.scans), asked);
  std::vector<FoundGroup> groups;
  for (std::size_t k = 1; k < asked.size(); ++k)
    if (isBroken(mended.evidence, k))
      groups.push_back(foundBehind(graph.runs[id].nodes, id, mended, k));
  return groups;
}

std::vector<PoseEdgeId> heldSteps(const Site& site, const Consensus& consensus,
                                  const ForEach& forEach) {
  const PoseGraph& graph = consensus.graph;
  ById<RunId, std::vector<PoseEdgeId>> found(graph.runs.size());
  forEach(found.size(), [&](std::size_t index) {
    const RunId run(index);
    if (graph.runs[run].hasScans && run != graph.reference)
      found[run] = heldBy(*site.runs[consensus.siteRuns[run]], graph.runs[run], consensus);
  });
  std::vector<PoseEdgeId> held;
  for (const std::vector<PoseEdgeId>& links : found)
    held.insert(held.end(), links.begin(), links.end());
  return held;
}

}  // namespace roomgraph
