#pragma once
#include <utility>
#include <vector>

#include "place_on_paths.h"
#include "roomgraph/grid/ObstacleRows.h"
#include "roomgraph/rooms/Room.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

/** The ways of a hall, which straight ones are added to. Keeps references to what it is made of. */
class HallGraph {
 public:
  HallGraph(TopologyGraph ways, const Room& room, const ObstacleRows& obstacles);
  /** What it has become. */
  [[nodiscard]] TopologyGraph take() && { return {std::move(vertices_), std::move(edges_)}; }

  [[nodiscard]] std::size_t size() const { return vertices_.size(); }
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  [[nodiscard]] Point placeOf(VertexId v) const { return vertices_[v.index()].place; }
  [[nodiscard]] bool isBorder(VertexId v) const {
    return vertices_[v.index()].kind == VertexKind::border;
  }
  /** So far along the way out of a border vertex [m]; of others, where they are. */
  [[nodiscard]] Point onTheWayFrom(VertexId v, double along) const;

  /** Along the ways, by vertex [m]: right up to `most`, and more than that beyond. By Dijkstra's
   *  algorithm. */
  [[nodiscard]] std::vector<double> lengthsFrom(VertexId start, double most) const;

  /** A straight way, in pieces between the ways that it crosses. Each end is the place on the ways
   *  that is nearest to it. O(ways), as below. */
  void addStraight(Point from, Point to);
  /** The same to a place that is not on the ways, and is a dead end then. Returns the way. */
  Path addDeadEnd(Point from, Point tip);

 private:
  VertexId vertexAt(Point point);
  VertexId split(PlaceOnPath place);
  void addStraight(VertexId from, VertexId to);
  std::vector<std::pair<double, PlaceOnPath>> crossed(Point p, Point q) const;
  void noteEnds(EdgeId e);
  VertexKind& kindOf(VertexId v) { return vertices_[v.index()].kind; }

  const Room& room_;
  const ObstacleRows& obstacles_;
  std::vector<Vertex> vertices_;
  std::vector<Edge> edges_;
  std::vector<std::vector<EdgeId>> edgesAt_;  // by vertex; some are elsewhere since they were split
};

}  // namespace roomgraph
