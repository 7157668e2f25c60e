#pragma once
#include <vector>

#include "roomgraph/base/Ids.h"
#include "roomgraph/topology/Path.h"

namespace roomgraph {

enum class VertexKind {  ///< what stands there
  junction,              ///< three or more ways meet; or a place with no way at all
  deadEnd,               ///< a way ends
  border,                ///< a way enters or leaves a room (paper II, "border vertex")
  room,                  ///< stands for a whole room
  ring                   ///< put on a closed way that has no junction
};

struct Vertex {
  Point place;                             ///< [m, map frame]
  double clearance = 0;                    ///< distance to the nearest obstacle [m]
  VertexKind kind = VertexKind::junction;  ///< what stands there
  RoomId room;  ///< the room it lies in or borders; none elsewhere (the paper's -1)
};

/** A way between two vertices, with its path from source to target. */
struct Edge {
  VertexId source, target;  ///< the path leads from the one to the other
  Path path;                ///< from source to target
  RoomId room;              ///< for paths inside of a room; none for corridors
};

/** Vertices joined by edges (paper II). Each edge is a pair of half edges, twins of each other; the
 *  half edge that runs as the path does has the even number. Parallel edges and self loops are
 *  legal: two doors may join the same two places, and a way may run round an obstacle. */
class TopologyGraph {
 public:
  TopologyGraph() = default;
  /** Every edge must join vertices of the graph. O(vertices + edges). */
  TopologyGraph(std::vector<Vertex> vertices, std::vector<Edge> edges);

  const std::vector<Vertex>& vertices() const { return vertices_; }        ///< by VertexId
  const std::vector<Edge>& edges() const { return edges_; }                ///< by EdgeId
  const Vertex& vertex(VertexId v) const { return vertices_[v.index()]; }  ///< must be there
  const Edge& edge(EdgeId e) const { return edges_[e.index()]; }           ///< must be there

  [[nodiscard]] static HalfEdgeId twin(HalfEdgeId h) { return HalfEdgeId(h.index() ^ 1); }
  [[nodiscard]] static EdgeId edgeOf(HalfEdgeId h) { return EdgeId(h.index() / 2); }
  [[nodiscard]] static bool runsAsPath(HalfEdgeId h) { return h.index() % 2 == 0; }
  const Edge& edge(HalfEdgeId h) const { return edge(edgeOf(h)); }  ///< of which it is a half
  [[nodiscard]] VertexId source(HalfEdgeId h) const {
    return runsAsPath(h) ? edge(h).source : edge(h).target;
  }
  [[nodiscard]] VertexId target(HalfEdgeId h) const { return source(twin(h)); }  ///< where it ends
  /** The path in the direction of the half edge (paper II, "half path"). A copy. */
  [[nodiscard]] Path halfPath(HalfEdgeId h) const;

  /** The half edges that leave `v`, by edge number; a self loop leaves twice. */
  struct HalfEdgeRange {
    const HalfEdgeId* first;
    const HalfEdgeId* last;
    const HalfEdgeId* begin() const { return first; }
    const HalfEdgeId* end() const { return last; }
    std::size_t size() const { return std::size_t(last - first); }
    HalfEdgeId front() const { return *first; }
  };
  [[nodiscard]] HalfEdgeRange outgoing(VertexId v) const;  ///< by HalfEdgeId
  [[nodiscard]] std::size_t degree(VertexId v) const { return outgoing(v).size(); }
  /** An edge one of whose ends has no other edge (paper II, "dead end"). */
  [[nodiscard]] bool isDeadEnd(EdgeId e) const;

  /** For changes that leave all ways where they are. */
  Vertex& vertex(VertexId v) { return vertices_[v.index()]; }
  void setRoom(EdgeId e, RoomId room) { edges_[e.index()].room = room; }

  /** Takes the parts out, for a step that builds its own graph from them. */
  std::vector<Vertex> takeVertices() && { return std::move(vertices_); }
  std::vector<Edge> takeEdges() && { return std::move(edges_); }

 private:
  std::vector<Vertex> vertices_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> firstOut_;  // per vertex into out_, one more at the end
  std::vector<HalfEdgeId> out_;
};

/** The graph of the vertices and edges that are flagged to be kept, in their order. Edges of a
 *  vertex that goes must not be kept. */
[[nodiscard]] TopologyGraph keepOnly(TopologyGraph graph, const std::vector<bool>& keepVertex,
                                     const std::vector<bool>& keepEdge);

/** Joins the two edges of every junction or dead end that has exactly two ends into one, and sets
 *  the kinds of junctions and dead ends anew. A cycle of such vertices keeps its widest one, as a
 *  ring vertex. Vertices of other kinds stay. */
[[nodiscard]] TopologyGraph dissolveThrough(TopologyGraph graph);

}  // namespace roomgraph
