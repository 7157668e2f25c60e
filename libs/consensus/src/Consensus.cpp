#include "roomgraph/consensus/Consensus.h"

#include "edge_cost.h"
#include "roomgraph/base/sentence_text.h"

namespace roomgraph {

std::string graphG2o(const Consensus& consensus) {
  const PoseGraph& graph = consensus.graph;
  std::string text;
  for (const NodeId node : graph.nodes.ids()) {
    const Transform2D& pose = consensus.poses[node];
    text += formatted("VERTEX_SE2 %zu %.6f %.6f %.9f\n", node.index(), pose.x, pose.y, pose.phi);
  }
  if (graph.nodes.size() > 0) text += "FIX 0\n";
  for (const PoseEdge& edge : graph.edges) {
    const PoseInformation known = informationOf(graph, edge, consensus.trust, consensus.poses);
    text += formatted("EDGE_SE2 %zu %zu %.6f %.6f %.9f %.6g 0 0 %.6g 0 %.6g\n", edge.from.index(),
                      edge.to.index(), edge.measured.x, edge.measured.y, edge.measured.phi,
                      known.place, known.place, known.turn);
  }
  return text;
}

}  // namespace roomgraph
