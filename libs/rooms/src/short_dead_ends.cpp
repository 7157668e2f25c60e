#include "roomgraph/rooms/short_dead_ends.h"

#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

bool isBorder(const TopologyGraph& graph, VertexId v) {
  return graph.vertex(v).kind == VertexKind::border;
}

/** The tip outside of the room of a dead end that starts at a border vertex; else none. */
VertexId outerTip(const TopologyGraph& graph, const Edge& edge) {
  for (const auto& [tip, base] :
       {std::pair(edge.source, edge.target), std::pair(edge.target, edge.source)})
    if (graph.degree(tip) == 1 && !graph.vertex(tip).room && isBorder(graph, base)) return tip;
  return VertexId::none();
}

bool leavesAndComesBack(const TopologyGraph& graph, const Edge& edge) {
  return !edge.room && isBorder(graph, edge.source) && isBorder(graph, edge.target) &&
         graph.vertex(edge.source).room == graph.vertex(edge.target).room;
}

/** A border vertex that borders nothing any more is a place inside of its room. */
void demoteLoneBorders(TopologyGraph& graph) {
  for (std::size_t v = 0; v < graph.vertices().size(); ++v) {
    Vertex& vertex = graph.vertex(VertexId(v));
    if (vertex.kind != VertexKind::border) continue;
    const auto out = graph.outgoing(VertexId(v));
    const bool bordersNothing =
        allOf(out, [&](HalfEdgeId h) { return graph.edge(h).room == vertex.room; });
    if (bordersNothing) vertex.kind = VertexKind::junction;
  }
}

}  // namespace

void describe(ShortDeadEndsOptions& options, FieldTable& table) {
  const char* section = "short_dead_ends";
  table.number(section, "min_length", options.minLength, "m", 0, 100,
               "Dead ends shorter than this that start at a room belong to it.");
  table.number(section, "min_length_px", options.minLengthPx, "px", 0, 1e5,
               "The same in cells, the paper's minLenThreshold; 0 for min_length.");
}

double shortLength(const ShortDeadEndsOptions& options, double resolution) {
  return options.minLengthPx > 0 ? options.minLengthPx * resolution : options.minLength;
}

TopologyGraph removeShortDeadEnds(TopologyGraph graph, double minLength) {
  std::vector<bool> keepVertex(graph.vertices().size(), true);
  std::vector<bool> keepEdge(graph.edges().size(), true);
  for (std::size_t e = 0; e < graph.edges().size(); ++e) {
    const Edge& edge = graph.edges()[e];
    if (edge.path.length >= minLength) continue;
    const VertexId tip = outerTip(graph, edge);
    if (tip) keepVertex[tip.index()] = false;
    keepEdge[e] = !tip && !leavesAndComesBack(graph, edge);
  }
  graph = keepOnly(std::move(graph), keepVertex, keepEdge);
  demoteLoneBorders(graph);
  // What a corridor loses may leave a junction with two ways: one path again.
  return dissolveThrough(std::move(graph));
}

}  // namespace roomgraph
