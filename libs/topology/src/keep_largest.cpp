#include "roomgraph/topology/keep_largest.h"

#include <algorithm>
#include <tuple>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/base/sentence_text.h"

namespace roomgraph {
namespace {

struct Component {
  double length = 0;
  Vertex widest;
  bool isEmpty = true;
};

bool isSmaller(const Component& a, const Component& b) {
  return std::tie(a.length, a.widest.clearance, b.widest.place) <
         std::tie(b.length, b.widest.clearance, a.widest.place);
}

/** One entry per vertex; filled in for the smallest vertex of each component. */
std::vector<Component> measure(const TopologyGraph& graph, UnionFind& groups) {
  std::vector<Component> components(graph.vertices().size());
  for (std::uint32_t v = 0; v < components.size(); ++v) {
    Component& component = components[groups.find(v)];
    const Vertex& vertex = graph.vertices()[v];
    if (component.isEmpty || vertex.clearance > component.widest.clearance)
      component.widest = vertex;
    component.isEmpty = false;
  }
  for (const Edge& edge : graph.edges())
    components[groups.find(edge.source.index())].length += edge.path.length;
  return components;
}

Note droppedNote(int count, double length, const Vertex& where) {
  return {"component_dropped",
          formatted("%d part%s of the graph with %.1f m of paths not connected to the largest one "
                    "%s dropped; --all-components keeps them",
                    count, count == 1 ? "" : "s", length, count == 1 ? "was" : "were"),
          std::array<double, 2>{where.place.x, where.place.y}};
}

}  // namespace

void describe(KeepLargestOptions& options, FieldTable& table) {
  const char* section = "keep_largest";
  table.flag(section, "all_components", options.allComponents,
             "Also keep the parts of the graph that are not connected to the largest one.");
  table.number(section, "min_length", options.minLength, "m", 0, 1e6,
               "Total path length from which such a part is kept.");
}

TopologyGraph keepLargest(TopologyGraph graph, const KeepLargestOptions& options, Notes& notes) {
  if (graph.vertices().empty()) return graph;
  UnionFind groups(graph.vertices().size());
  for (const Edge& edge : graph.edges()) groups.join(edge.source.index(), edge.target.index());
  std::vector<Component> components = measure(graph, groups);
  const auto largest = std::max_element(components.begin(), components.end(), isSmaller);
  std::vector<bool> keepComponent(components.size());
  Component biggestDropped;
  int droppedCount = 0;
  double droppedLength = 0;
  for (auto it = components.begin(); it != components.end(); ++it) {
    if (it->isEmpty) continue;
    const bool isKept = it == largest || (options.allComponents && it->length >= options.minLength);
    keepComponent[std::size_t(it - components.begin())] = isKept;
    if (isKept) continue;
    ++droppedCount;
    droppedLength += it->length;
    if (biggestDropped.isEmpty || isSmaller(biggestDropped, *it)) biggestDropped = *it;
  }
  if (droppedCount > 0)
    notes.push_back(droppedNote(droppedCount, droppedLength, biggestDropped.widest));
  std::vector<bool> keepVertex(graph.vertices().size()), keepEdge(graph.edges().size());
  for (std::uint32_t v = 0; v < keepVertex.size(); ++v)
    keepVertex[v] = keepComponent[groups.find(v)];
  for (std::size_t e = 0; e < keepEdge.size(); ++e)
    keepEdge[e] = keepVertex[graph.edges()[e].source.index()];
  return keepOnly(std::move(graph), keepVertex, keepEdge);
}

}  // namespace roomgraph
