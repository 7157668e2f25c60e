#include "roomgraph/rooms/room_ids.h"

#include <algorithm>
#include <map>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/rooms/RoomIndex.h"

namespace roomgraph {
namespace {

/** A path that only clips a corner of a polygon does not enter the room: of the paths in a room,
 *  those stay that are connected to its longest ones; the others become corridors. */
void leaveClippedRooms(TopologyGraph& graph) {
  const auto& edges = graph.edges();
  UnionFind groups(edges.size());
  for (std::size_t v = 0; v < graph.vertices().size(); ++v) {
    const auto out = graph.outgoing(VertexId(v));
    for (const HalfEdgeId a : out)
      for (const HalfEdgeId b : out)
        if (graph.edge(a).room == graph.edge(b).room) groups.join(a.index() / 2, b.index() / 2);
  }
  std::vector<double> lengthOf(edges.size());
  for (std::uint32_t e = 0; e < edges.size(); ++e) lengthOf[groups.find(e)] += edges[e].path.length;
  std::map<RoomId, std::uint32_t> mainGroup;
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    if (!edges[e].room) continue;
    const auto group = groups.find(e);
    const auto it = mainGroup.emplace(edges[e].room, group).first;
    if (lengthOf[group] > lengthOf[it->second]) it->second = group;
  }
  for (std::uint32_t e = 0; e < edges.size(); ++e)
    if (edges[e].room && mainGroup.at(edges[e].room) != groups.find(e))
      graph.setRoom(EdgeId(e), RoomId::none());
}

/** The room of a vertex by the paths that end at it. */
void setRoom(TopologyGraph& graph, VertexId v) {
  Vertex& vertex = graph.vertex(v);
  const auto out = graph.outgoing(v);
  const RoomId first = graph.edge(out.front()).room;
  RoomId smallest = first;
  bool isMixed = false;
  for (const HalfEdgeId h : out) {
    smallest = std::min(smallest, graph.edge(h).room);
    isMixed = isMixed || graph.edge(h).room != first;
  }
  vertex.room = smallest;
  if (isMixed) vertex.kind = VertexKind::border;
  if (!isMixed && vertex.kind == VertexKind::border) vertex.kind = VertexKind::junction;
}

}  // namespace

TopologyGraph roomIds(TopologyGraph graph, const Rooms& rooms) {
  leaveClippedRooms(graph);
  const RoomIndex index(rooms);
  for (std::size_t i = 0; i < graph.vertices().size(); ++i) {
    const VertexId v(i);
    if (graph.degree(v) == 0)
      graph.vertex(v).room = index.roomAt(graph.vertex(v).place);
    else
      setRoom(graph, v);
  }
  return graph;
}

}  // namespace roomgraph
