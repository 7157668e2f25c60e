#include "HallGraph.h"

#include <algorithm>
#include <limits>
#include <queue>

#include "roomgraph/geometry/intersect.h"
#include "straight_ways.h"

namespace roomgraph {

HallGraph::HallGraph(TopologyGraph ways, const Room& room, const ObstacleRows& obstacles)
    : room_(room),
      obstacles_(obstacles),
      vertices_(ways.vertices()),
      edges_(std::move(ways).takeEdges()),
      edgesAt_(vertices_.size()) {
  for (std::size_t e = 0; e < edges_.size(); ++e) noteEnds(EdgeId(e));
}

Point HallGraph::onTheWayFrom(VertexId v, double along) const {
  if (!isBorder(v)) return placeOf(v);
  for (const Edge& edge : edges_) {
    const double there = std::min(along, edge.path.length);
    if (edge.source == v) return placeOn(edge.path, there);
    if (edge.target == v) return placeOn(edge.path, edge.path.length - there);
  }
  return placeOf(v);
}

std::vector<double> HallGraph::lengthsFrom(VertexId start, double most) const {
  std::vector<double> lengthTo(vertices_.size(), std::numeric_limits<double>::infinity());
  using Reached = std::pair<double, VertexId>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  const auto reach = [&](VertexId v, double length) {
    if (length < lengthTo[v.index()]) lengthTo[v.index()] = length, open.push({length, v});
  };
  for (reach(start, 0); !open.empty() && open.top().first <= most;) {
    const auto [length, v] = open.top();
    open.pop();
    if (length > lengthTo[v.index()]) continue;
    for (const EdgeId e : edgesAt_[v.index()]) {
      const Edge& edge = edges_[e.index()];
      // Of an edge that was split there since, the far part is another one.
      if (edge.source == v) reach(edge.target, length + edge.path.length);
      if (edge.target == v) reach(edge.source, length + edge.path.length);
    }
  }
  return lengthTo;
}

void HallGraph::addStraight(Point from, Point to) {
  const VertexId end = vertexAt(to);
  addStraight(vertexAt(from), end);
}

Path HallGraph::addDeadEnd(Point from, Point tip) {
  const VertexId base = vertexAt(from), end(vertices_.size());
  vertices_.push_back(
      {tip, obstacles_.clearance(tip, tip, room_.inscribedRadius), VertexKind::junction, {}});
  edgesAt_.emplace_back();
  addStraight(base, end);
  kindOf(end) = VertexKind::deadEnd;
  return straightPath(obstacles_, from, tip, 0);
}

/** Of the place on the ways that is nearest to a point. */
VertexId HallGraph::vertexAt(Point point) {
  PlaceOnPath best;
  double offset = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const Path& path = edges_[e].path;
    double along = 0;
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
      const Point place = nearestOnSegment(point, path.points[i], path.points[i + 1]);
      if (distance(place, point) < offset) {
        offset = distance(place, point);
        best = {EdgeId(e), std::min(path.length, along + distance(path.points[i], place))};
      }
      along += distance(path.points[i], path.points[i + 1]);
    }
  }
  return split(best);
}

VertexId HallGraph::split(PlaceOnPath place) {
  const std::size_t count = vertices_.size();
  const VertexId v = splitAt(vertices_, edges_, place, VertexKind::junction);
  if (count == vertices_.size()) return v;
  edgesAt_.push_back({place.edge});
  noteEnds(EdgeId(edges_.size() - 1));
  if (!edges_.back().path.obstacles.empty()) return v;
  vertices_.back().clearance = obstacles_.clearance(placeOf(v), placeOf(v), room_.inscribedRadius);
  for (Edge* part : {&edges_[place.edge.index()], &edges_.back()}) {
    Path& path = part->path;
    path.minClearance = vertices_.back().clearance;
    for (std::size_t i = 1; i < path.points.size(); ++i)
      path.minClearance =
          obstacles_.clearance(path.points[i - 1], path.points[i], path.minClearance);
  }
  return v;
}

void HallGraph::addStraight(VertexId from, VertexId to) {
  std::vector<std::pair<double, VertexId>> stops{{0, from}, {1, to}};
  std::vector<std::pair<double, PlaceOnPath>> crossings = crossed(placeOf(from), placeOf(to));
  for (auto it = crossings.rbegin(); it != crossings.rend(); ++it)  // the first part keeps its id
    stops.push_back({it->first, split(it->second)});
  std::sort(stops.begin(), stops.end());
  for (const auto& [at, v] : stops)
    if (kindOf(v) == VertexKind::deadEnd) kindOf(v) = VertexKind::junction;
  for (std::size_t i = 1; i < stops.size(); ++i) {
    const VertexId a = stops[i - 1].second, b = stops[i].second;
    if (a == b) continue;
    const double clearance =
        std::min(vertices_[a.index()].clearance, vertices_[b.index()].clearance);
    edges_.push_back({a, b, straightPath(obstacles_, placeOf(a), placeOf(b), clearance), {}});
    noteEnds(EdgeId(edges_.size() - 1));
  }
}

/** By edge, and then from its source on. */
std::vector<std::pair<double, PlaceOnPath>> HallGraph::crossed(Point p, Point q) const {
  std::vector<std::pair<double, PlaceOnPath>> all;
  const double way = distance(p, q);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const Polyline& points = edges_[e].path.points;
    double along = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      for (const double at : intersect(p, q, points[i], points[i + 1]))
        if (std::min(at, 1 - at) * way > kSamePlace)
          all.push_back({at, {EdgeId(e), along + distance(points[i], p + at * (q - p))}});
      along += distance(points[i], points[i + 1]);
    }
  }
  return all;
}

void HallGraph::noteEnds(EdgeId e) {
  edgesAt_[edges_[e.index()].source.index()].push_back(e);
  edgesAt_[edges_[e.index()].target.index()].push_back(e);
}

}  // namespace roomgraph
