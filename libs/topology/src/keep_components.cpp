#include "roomgraph/topology/keep_components.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/base/sentence_text.h"

namespace roomgraph {
namespace {

struct Component {
  double length = 0;
  Vertex widest;
  std::vector<VertexId> vertices;
  std::vector<EdgeId> edges;
};

bool isLarger(const Component& a, const Component& b) {
  return std::tie(b.length, b.widest.clearance, a.widest.place) <
         std::tie(a.length, a.widest.clearance, b.widest.place);
}

/** Larger ones first. */
std::vector<Component> componentsOf(const TopologyGraph& graph) {
  UnionFind groups(graph.vertices().size());
  for (const Edge& edge : graph.edges()) groups.join(edge.source.index(), edge.target.index());
  std::vector<Component> components;
  std::map<std::uint32_t, std::size_t> places;  // of each group
  const auto componentAt = [&](VertexId v) -> Component& {
    const auto [place, isNew] = places.emplace(groups.find(v.index()), components.size());
    if (isNew) components.push_back({0, graph.vertex(v), {}, {}});
    return components[place->second];
  };
  for (std::size_t v = 0; v < graph.vertices().size(); ++v) {
    Component& component = componentAt(VertexId(v));
    if (graph.vertex(VertexId(v)).clearance > component.widest.clearance)
      component.widest = graph.vertex(VertexId(v));
    component.vertices.push_back(VertexId(v));
  }
  for (std::size_t e = 0; e < graph.edges().size(); ++e) {
    Component& component = componentAt(graph.edges()[e].source);
    component.length += graph.edges()[e].path.length;
    component.edges.push_back(EdgeId(e));
  }
  std::sort(components.begin(), components.end(), isLarger);
  return components;
}

std::set<RoomId> regionsOf(const Component& component, const TopologyGraph& graph,
                           const RegionAt& regionAt) {
  std::set<RoomId> regions;
  const auto add = [&](Point place) {
    if (const RoomId region = regionAt(place)) regions.insert(region);
  };
  for (const VertexId v : component.vertices) add(graph.vertex(v).place);
  for (const EdgeId e : component.edges)
    for (const Point place : graph.edge(e).path.points) add(place);
  return regions;
}

/** Which of them lead into regions that no larger one leads into. */
std::vector<bool> leadOn(const std::vector<Component>& components, const TopologyGraph& graph,
                         const RegionAt& regionAt) {
  std::vector<bool> lead(components.size());
  std::set<RoomId> known;
  for (std::size_t c = 0; c < components.size() && components.size() > 1; ++c) {
    const std::size_t before = known.size();
    known.merge(regionsOf(components[c], graph, regionAt));
    lead[c] = known.size() > before;
  }
  return lead;
}

Note droppedNote(std::size_t count, double length, const Vertex& where) {
  return {
      "component_dropped",
      formatted("%zu part%s of the graph, with %.1f m of paths, %s dropped: nothing joins %s to "
                "the rest",
                count, count == 1 ? "" : "s", length, count == 1 ? "was" : "were",
                count == 1 ? "it" : "them"),
      std::array<double, 2>{where.place.x, where.place.y}};
}

}  // namespace

void describe(KeepComponentsOptions& options, FieldTable& table) {
  table.flag(
      "keep_components", "only_largest", options.onlyLargest,
      "Keep only the largest of the parts of the graph that are not connected, as the paper "
      "does, and not those that lead into further rooms, or into corridors no smaller than the "
      "median room.");
}

TopologyGraph keepComponents(TopologyGraph graph, const RegionAt& regionAt,
                             const KeepComponentsOptions& options, Notes& notes) {
  const std::vector<Component> components = componentsOf(graph);
  std::vector<bool> isKept(components.size());
  if (!options.onlyLargest) isKept = leadOn(components, graph, regionAt);
  std::vector<bool> keepVertex(graph.vertices().size()), keepEdge(graph.edges().size());
  std::vector<const Component*> dropped;
  double droppedLength = 0;
  for (std::size_t c = 0; c < components.size(); ++c) {
    const Component& component = components[c];
    if (c > 0 && !isKept[c]) {
      dropped.push_back(&component), droppedLength += component.length;
      continue;
    }
    for (const VertexId v : component.vertices) keepVertex[v.index()] = true;
    for (const EdgeId e : component.edges) keepEdge[e.index()] = true;
  }
  if (!dropped.empty())
    notes.push_back(droppedNote(dropped.size(), droppedLength, dropped.front()->widest));
  return keepOnly(std::move(graph), keepVertex, keepEdge);
}

}  // namespace roomgraph
