#include "own_matches.h"

#include <algorithm>

#include "edge_cost.h"
#include "fitted_consensus.h"
#include "roomgraph/align/LocalScan.h"
#include "roomgraph/align/step_hold.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/consensus/StepWitness.h"
#include "roomgraph/consensus/belief.h"
#include "roomgraph/consensus/mend_steps.h"

namespace roomgraph {
namespace {

/** Whether the step to a scan is broken. Where one step after the other is wrong, the robot was in
 *  a lift, or its scanner covered. */
bool isBroken(const std::vector<StepEvidence>& steps, std::size_t k) {
  if (steps[k] != StepEvidence::contradicts) return false;
  constexpr auto kNear = std::size_t(fitted::kLeastLostOnEnd);
  const auto first = steps.begin() + std::ptrdiff_t(k - std::min(k, kNear - 1));
  const auto end = steps.begin() + std::ptrdiff_t(std::min(steps.size(), k + kNear));
  return std::count_if(first, end, speaksAgainst) == 1;
}

/** The scans from `k` on, as they lie in the one before it. */
FoundGroup foundBehind(const IdRange<NodeId>& nodes, RunId id, const MendedSteps& mended,
                       std::size_t k) {
  FoundGroup found{{id, id, {}}, {}};
  const std::size_t end = std::min(nodes.size(), k + fitted::kLongScans);
  for (std::size_t i = k; i < end; ++i) {
    if (i > k && speaksAgainst(mended.evidence[i])) break;
    const Transform2D measured = mended.poses[k - 1].inverse() * mended.poses[i];
    found.matches.push_back(matchEdge(nodes[k - 1], nodes[i], measured, 1));
  }
  return found;
}

/** The scans of a run behind links that have given way, and are not held. */
std::vector<std::size_t> tearsOf(const GraphRun& run, const Consensus& consensus) {
  std::vector<std::size_t> tears;
  for (const PoseEdgeId id : run.links) {
    const PoseEdge& link = consensus.graph.edges[id];
    if (link.share <= 1 && !isInlier(link, gapOf(link, consensus.poses), kInlier))
      tears.push_back(run.nodes.placeOf(link.to));
  }
  return tears;
}

/** Looks for the links of a run that have to hold. */
class HeldLinks {
 public:
  HeldLinks(const Run& run, const GraphRun& nodes, const Consensus& consensus)
      : nodes_(nodes),
        consensus_(consensus),
        scans_(localScans(run.scans)),
        drawn_(drawnPoses(run.scans)) {}

  /** Those that have given way and are refuted, and others, up to the next tears of the run, at
   *  which walls refute the same motion: else it is torn there instead. */
  std::vector<PoseEdgeId> held(const std::vector<std::size_t>& tears) {
    std::vector<PoseEdgeId> held;
    for (std::size_t i = 0; i < tears.size(); ++i) {
      const Transform2D motion = motionAt(tears[i]);
      if (!refutes(tears[i], motion, RefutedBy::wallsOrGait)) continue;
      held.push_back(linkTo(tears[i]));
      const std::size_t end = i + 1 < tears.size() ? tears[i + 1] : drawn_.size();
      for (std::size_t k = i > 0 ? tears[i - 1] + 1 : 1; k < end; ++k)
        if (refutes(k, motion, RefutedBy::walls)) held.push_back(linkTo(k));
    }
    sortUnique(held);
    return held;
  }

 private:
  PoseEdgeId linkTo(std::size_t scan) const { return nodes_.links[scan - 1]; }

  /** By which all from a scan on lies off, in the frame of the run. */
  Transform2D motionAt(std::size_t k) const {
    const auto moved = [&](std::size_t scan) {  // site <- run
      return consensus_.poses[nodes_.nodes[scan]] * drawn_[scan].inverse();
    };
    return moved(k - 1).inverse() * moved(k);
  }

  bool refutes(std::size_t k, const Transform2D& motion, RefutedBy by) {
    return witness_.refutes(k, drawn_[k - 1].inverse() * motion * drawn_[k], by);
  }

  const GraphRun& nodes_;
  const Consensus& consensus_;
  std::vector<LocalScan> scans_;
  std::vector<Transform2D> drawn_;
  StepWitness witness_{scans_, drawn_};
};

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
  if (!contains(asked, true)) return {};
  const MendedSteps mended = mendSteps(localScans(run.scans), drawnPoses(run.scans), asked);
  std::vector<FoundGroup> groups;
  for (std::size_t k = 1; k < asked.size(); ++k)
    if (isBroken(mended.evidence, k))
      groups.push_back(foundBehind(graph.runs[id].nodes, id, mended, k));
  return groups;
}

std::size_t tornRuns(const Consensus& consensus) {
  const PoseGraph& graph = consensus.graph;
  const auto gaveWay = [&](PoseEdgeId id) {
    const PoseEdge& link = graph.edges[id];
    return termOf(graph, link, consensus.trust).cost(gapOf(link, consensus.poses)) > kGaveWay;
  };
  std::size_t torn = 0;
  for (const GraphRun& run : graph.runs) torn += contains(mapped(run.links, gaveWay), true);
  return torn;
}

std::vector<PoseEdgeId> heldSteps(const Site& site, const Consensus& consensus,
                                  const ForEach& forEach) {
  const PoseGraph& graph = consensus.graph;
  return gathered<PoseEdgeId>(graph, forEach, [&](RunId run) -> std::vector<PoseEdgeId> {
    const std::vector<std::size_t> tears = tearsOf(graph.runs[run], consensus);
    if (tears.empty()) return {};
    const Run& scans = *site.runs[consensus.siteRuns[run]];
    return HeldLinks(scans, graph.runs[run], consensus).held(tears);
  });
}

}  // namespace roomgraph
