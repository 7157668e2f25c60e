#include "place_on_paths.h"

#include <algorithm>
#include <limits>

namespace roomgraph {
namespace {

/** Of the points of the paths with at least `minClearance`, but border vertices; the edge is
 *  none where there is none. */
PlaceOnPath nearestPlace(const TopologyGraph& graph, const std::vector<EdgeId>& edges, Point p,
                         double minClearance) {
  PlaceOnPath best;
  double offset = std::numeric_limits<double>::infinity();
  for (const EdgeId e : edges) {
    double along = 0;
    const Polyline& points = graph.edge(e).path.points;
    const std::vector<Point>& obstacles = graph.edge(e).path.obstacles;
    const auto isBorder = [&](VertexId v) { return graph.vertex(v).kind == VertexKind::border; };
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i > 0) along += distance(points[i - 1], points[i]);
      // The end by the path's own length, which may be rounded otherwise than this sum.
      const double here = i + 1 < points.size() ? along : graph.edge(e).path.length;
      const double clearance = distance(points[i], obstacles[i > 0 ? i - 1 : 0]);
      const double left = graph.edge(e).path.length - here;
      const bool isRoomEnd = (here < kSamePlace && isBorder(graph.edge(e).source)) ||
                             (left < kSamePlace && isBorder(graph.edge(e).target));
      if (isRoomEnd) continue;
      if (clearance >= minClearance && distance(points[i], p) < offset)
        best = {e, here}, offset = distance(points[i], p);
    }
  }
  return best;
}

double widestOf(const TopologyGraph& graph, const std::vector<EdgeId>& edges) {
  double widest = 0;
  for (const EdgeId e : edges) {
    const Path& path = graph.edge(e).path;
    for (std::size_t i = 0; i < path.obstacles.size(); ++i)
      widest = std::max(widest, distance(path.points[i + 1], path.obstacles[i]));
  }
  return widest;
}

PlaceOnPath middleOfLongest(const TopologyGraph& graph, const std::vector<EdgeId>& edges) {
  const auto lengthOf = [&](EdgeId e) { return graph.edge(e).path.length; };
  const EdgeId longest = *std::max_element(
      edges.begin(), edges.end(), [&](EdgeId l, EdgeId r) { return lengthOf(l) < lengthOf(r); });
  return {longest, lengthOf(longest) / 2};
}

}  // namespace

VertexId splitAt(std::vector<Vertex>& vertices, std::vector<Edge>& edges, PlaceOnPath place,
                 VertexKind kind) {
  Edge& whole = edges[place.edge.index()];
  const double rest = whole.path.length - place.along;
  if (std::min(place.along, rest) < kSamePlace)
    return place.along <= rest ? whole.source : whole.target;
  const VertexId middle(vertices.size());
  vertices.push_back(
      {placeOn(whole.path, place.along), clearanceAt(whole.path, place.along), kind, whole.room});
  Edge second{middle, whole.target, piece(whole.path, place.along, whole.path.length), whole.room};
  whole.path = piece(whole.path, 0, place.along);
  whole.target = middle;
  edges.push_back(std::move(second));
  return middle;
}

PlaceOnPath placeOnPaths(const TopologyGraph& graph, const std::vector<EdgeId>& edges, Point p,
                         double minClearance) {
  const PlaceOnPath place =
      nearestPlace(graph, edges, p, std::min(minClearance, widestOf(graph, edges) / 2));
  return place.edge ? place : middleOfLongest(graph, edges);
}

}  // namespace roomgraph
