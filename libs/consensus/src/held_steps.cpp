#include "held_steps.h"

#include "roomgraph/align/LocalScan.h"
#include "roomgraph/consensus/belief.h"
#include "roomgraph/consensus/mend_steps.h"

namespace roomgraph {
namespace {

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
