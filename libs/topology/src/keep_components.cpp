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

std::set<RoomId> roomsOf(const Component& component, const TopologyGraph& graph,
                         const RoomAt& roomAt) {
  std::set<RoomId> rooms;
  const auto add = [&](Point place) {
    if (const RoomId room = roomAt(place)) rooms.insert(room);
  };
  for (const VertexId v : component.vertices) add(graph.vertex(v).place);
  for (const EdgeId e : component.edges)
    for (const Point place : graph.edge(e).path.points) add(place);
  return rooms;
}

/** Which of them lead into rooms that no larger one leads into. */
std::vector<bool> leadIntoNewRooms(const std::vector<Component>& components,
                                   const TopologyGraph& graph, const RoomAt& roomAt) {
  std::vector<bool> lead(components.size());
  std::set<RoomId> known;
  for (std::size_t c = 0; c < components.size() && components.size() > 1; ++c) {
    const std::size_t before = known.size();
    known.merge(roomsOf(components[c], graph, roomAt));
    lead[c] = known.size() > before;
  }
  return lead;
}

Note droppedNote(std::size_t count, double length, const std::string& rule, const Vertex& where) {
  const bool isOne = count == 1;
  return {"component_dropped",
          formatted("%zu unconnected part%s of the graph %s dropped, with %.1f m of paths%s", count,
                    isOne ? "" : "s", isOne ? "was" : "were", length, rule.c_str()),
          std::array<double, 2>{where.place.x, where.place.y}};
}

std::string ruleText(const KeepComponentsOptions& options) {
  if (options.which == "all") return "";
  return (options.which == "largest" ? "" : " that lead into no further room") +
         std::string(": --all-components keeps those from ") +
         formatted("%g m up", options.minLength);
}

}  // namespace

void describe(KeepComponentsOptions& options, FieldTable& table) {
  const char* section = "keep_components";
  table.choice(section, "which", options.which, {"largest", "with_rooms", "all"},
               "Which unconnected parts of the graph are kept: the largest one, as in the paper; "
               "also those that lead into further rooms; or all.");
  table.number(section, "min_length", options.minLength, "m", 0, 1e6,
               "Total path length from which a part is kept only because all are.");
}

TopologyGraph keepComponents(TopologyGraph graph, const RoomAt& roomAt,
                             const KeepComponentsOptions& options, Notes& notes) {
  const std::vector<Component> components = componentsOf(graph);
  std::vector<bool> isKept(components.size());
  if (options.which != "largest") isKept = leadIntoNewRooms(components, graph, roomAt);
  std::vector<bool> keepVertex(graph.vertices().size()), keepEdge(graph.edges().size());
  std::vector<const Component*> dropped;
  double droppedLength = 0;
  for (std::size_t c = 0; c < components.size(); ++c) {
    const Component& component = components[c];
    const bool isLong = options.which == "all" && component.length >= options.minLength;
    if (c == 0 || isKept[c] || isLong) {
      for (const VertexId v : component.vertices) keepVertex[v.index()] = true;
      for (const EdgeId e : component.edges) keepEdge[e.index()] = true;
    } else {
      dropped.push_back(&component), droppedLength += component.length;
    }
  }
  if (!dropped.empty())
    notes.push_back(
        droppedNote(dropped.size(), droppedLength, ruleText(options), dropped.front()->widest));
  return keepOnly(std::move(graph), keepVertex, keepEdge);
}

}  // namespace roomgraph
