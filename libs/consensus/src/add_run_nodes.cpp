#include "roomgraph/consensus/add_run_nodes.h"

namespace roomgraph {
namespace {

void addScans(const Run& run, PoseGraph& graph) {
  NodeId last;
  for (const ScanWalls& scan : run.scans) {
    const NodeId node = graph.addNode(scan.pose, scan.ends, scan.axes);
    if (last) graph.addLink(last, node);
    last = node;
  }
}

void addPatches(const WallMap& map, PoseGraph& graph) {
  for (const WallPatch& patch : map.patches) {
    PointSums points;
    for (const std::uint32_t wall : patch.own) points.add(map.walls[wall].place - patch.middle);
    graph.addNode({patch.middle.x, patch.middle.y, 0}, points, std::nullopt);
  }
}

}  // namespace

RunId addRunNodes(const Run& run, PoseGraph& graph) {
  const RunId id = graph.addRun(!run.scans.empty());
  if (graph.runs[id].hasScans) {
    addScans(run, graph);
    return id;
  }
  addPatches(run.map, graph);
  const IdRange<NodeId> nodes = graph.runs[id].nodes;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    for (const std::uint32_t next : run.map.patches[k].neighbours)
      if (next > k) graph.addLink(nodes[k], nodes[next]);
  return id;
}

}  // namespace roomgraph
