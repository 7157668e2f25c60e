#include "roomgraph/consensus/agreed_bends.h"

#include <algorithm>
#include <map>

#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/geometry/MotionFit.h"

namespace roomgraph {
namespace {

/** Of each two runs of a graph, how what was found of the second one in the first has moved. */
using FoundTable = std::map<std::pair<RunId, RunId>, MotionFit>;

FoundTable foundIn(const Consensus& consensus) {
  const PoseGraph& graph = consensus.graph;
  FoundTable found;
  for (const MatchGroupId id : graph.groups.ids()) {
    const MatchGroup& group = graph.groups[id];
    if (group.from == group.to || consensus.trust.belief[id] < kMajority) continue;
    for (const PoseEdgeId edge : group.edges) {
      const PoseNode &from = graph.nodes[graph.edges[edge].from],
                     &to = graph.nodes[graph.edges[edge].to];
      const Transform2D there =
          consensus.poses[graph.edges[edge].from].inverse() * consensus.poses[graph.edges[edge].to];
      found[{group.from, group.to}].add(to.points, to.pose, from.pose * there);
    }
  }
  return found;
}

}  // namespace

PairBends agreedBends(const Site& site, const Consensus& consensus, PairBends bends) {
  if (anyOf(site.runs, [](const Run* run) { return run->scans.empty(); })) return bends;
  const FoundTable found = foundIn(consensus);
  for (const auto& [i, j] : bends.pairs()) {
    const RunId a = consensus.graphRuns[i], b = consensus.graphRuns[j];
    const auto ofA = found.find({b, a}), ofB = found.find({a, b});
    if (ofA == found.end() && ofB == found.end()) continue;
    bends(i, j).bend = 0;
    for (const auto& one : {ofA, ofB})
      if (one != found.end()) bends(i, j).bend = std::max(bends(i, j).bend, one->second.rest());
  }
  return bends;
}

}  // namespace roomgraph
