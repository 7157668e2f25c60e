#include "place_on_paths.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "roomgraph/topology/VoronoiGraph.h"

namespace roomgraph {
namespace {

/** At one of the points of a path [m]. */
double clearanceAtPoint(const Path& path, std::size_t i) {
  return distance(path.points[i], path.obstacles[i > 0 ? i - 1 : 0]);
}

/** Of the points of the paths with at least `minClearance`, but border vertices, the nearest; of
 *  those as near the widest. The edge is none where there is none. */
PlaceOnPath nearestPlace(const TopologyGraph& graph, const std::vector<EdgeId>& edges, Point p,
                         double minClearance) {
  PlaceOnPath best;
  std::pair offset(std::numeric_limits<float>::infinity(), 0.0F);
  for (const EdgeId e : edges) {
    double along = 0;
    const Polyline& points = graph.edge(e).path.points;
    const auto isBorder = [&](VertexId v) { return graph.vertex(v).kind == VertexKind::border; };
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i > 0) along += distance(points[i - 1], points[i]);
      // The end by the path's own length, which may be rounded otherwise than this sum.
      const double here = i + 1 < points.size() ? along : graph.edge(e).path.length;
      const double clearance = clearanceAtPoint(graph.edge(e).path, i);
      const double left = graph.edge(e).path.length - here;
      const bool isRoomEnd = (here < kSamePlace && isBorder(graph.edge(e).source)) ||
                             (left < kSamePlace && isBorder(graph.edge(e).target));
      if (isRoomEnd) continue;
      const std::pair away(float(distance(points[i], p)), -float(clearance));
      if (clearance >= minClearance * (1 - kSameWidth) && away < offset)
        best = {e, here}, offset = away;
    }
  }
  return best;
}

double widestOf(const TopologyGraph& graph, const std::vector<EdgeId>& edges) {
  double widest = 0;
  for (const EdgeId e : edges) {
    const Path& path = graph.edge(e).path;
    for (std::size_t i = 0; i < path.points.size(); ++i)
      widest = std::max(widest, clearanceAtPoint(path, i));
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
