#include "roomgraph/consensus/graph_g2o.h"

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
    const Transform2D found = consensus.poses[edge.from].inverse() * consensus.poses[edge.to];
    const EdgeTerm term = termOf(graph, edge, consensus.trust);
    const double place = distance(found.shift(), edge.measured.shift()) / term.noise.place;
    const double turn = wrappedAngle(found.phi - edge.measured.phi) / term.noise.turn;
    const double left = 1 / (1 + (place * place + turn * turn) / (term.width * term.width));
    const double weight = term.weight * left;
    text += formatted("EDGE_SE2 %zu %zu %.6f %.6f %.9f %.6g 0 0 %.6g 0 %.6g\n", edge.from.index(),
                      edge.to.index(), edge.measured.x, edge.measured.y, edge.measured.phi,
                      weight / (term.noise.place * term.noise.place),
                      weight / (term.noise.place * term.noise.place),
                      weight / (term.noise.turn * term.noise.turn));
  }
  return text;
}

}  // namespace roomgraph
