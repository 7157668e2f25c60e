#include "roomgraph/rooms/inner_paths.h"

#include <algorithm>
#include <limits>
#include <map>
#include <queue>
#include <tuple>

namespace roomgraph {
namespace {

/** Far from the origin, points of a path that follow each other may differ by rounding only [m]. */
constexpr double kSamePlace = 1e-6;

/** A place on a path. */
struct PlaceOnPath {
  EdgeId edge;
  double along = 0;
  double offset = std::numeric_limits<double>::infinity();  // from the place that was asked for
};

/** Of the points of the paths with at least `minClearance`, but border vertices: the room's own
 *  vertex is not one of those. The edge is none where there is none. */
PlaceOnPath nearestPlace(const TopologyGraph& graph, const std::vector<EdgeId>& edges, Point p,
                         double minClearance) {
  PlaceOnPath best;
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
      if (clearance >= minClearance && distance(points[i], p) < best.offset)
        best = {e, here, distance(points[i], p)};
    }
  }
  return best;
}

/** Halfway on the longest of the paths. */
PlaceOnPath middleOfLongest(const TopologyGraph& graph, const std::vector<EdgeId>& edges) {
  const auto lengthOf = [&](EdgeId e) { return graph.edge(e).path.length; };
  const EdgeId longest = *std::max_element(
      edges.begin(), edges.end(), [&](EdgeId l, EdgeId r) { return lengthOf(l) < lengthOf(r); });
  return {longest, lengthOf(longest) / 2, 0};
}

/** Distance to the nearest obstacle of a place on a path [m]. */
double clearanceAt(const Path& path, double along) {
  double end = 0;
  std::size_t i = 0;
  for (; i + 1 < path.obstacles.size(); ++i) {
    end += distance(path.points[i], path.points[i + 1]);
    if (along <= end) break;
  }
  return distance(placeOn(path, along), path.obstacles[i]);
}

/** Shortest ways from one place to all vertices that the given edges reach. */
class ShortestWays {
 public:
  ShortestWays(const TopologyGraph& graph, const std::vector<EdgeId>& edges, PlaceOnPath start)
      : graph_(graph) {
    for (const EdgeId e : edges)
      for (const HalfEdgeId h : {HalfEdgeId(2 * e.index()), HalfEdgeId(2 * e.index() + 1)})
        ways_[graph.source(h)].push_back(h);
    const Edge& edge = graph.edge(start.edge);
    offer(edge.target, edge.path.length - start.along, HalfEdgeId::none(),
          piece(edge.path, start.along, edge.path.length));
    offer(edge.source, start.along, HalfEdgeId::none(), reversed(piece(edge.path, 0, start.along)));
    run();
  }

  Path pathTo(VertexId v) const {
    const Way& way = best_.at(v);
    if (!way.last) return way.first;
    return joined(pathTo(graph_.source(way.last)), graph_.halfPath(way.last));
  }

 private:
  struct Way {
    double length;
    HalfEdgeId last;  // none where `first` leads all the way
    Path first;
  };
  using Entry = std::tuple<double, VertexId>;

  void offer(VertexId v, double length, HalfEdgeId last, Path first) {
    const auto it = best_.find(v);
    if (it != best_.end() && it->second.length <= length) return;
    best_[v] = {length, last, std::move(first)};
    open_.push({length, v});
  }

  void run() {
    while (!open_.empty()) {
      const auto [length, at] = open_.top();
      open_.pop();
      if (length > best_.at(at).length) continue;
      for (const HalfEdgeId h : ways_[at])
        offer(graph_.target(h), length + graph_.edge(h).path.length, h, {});
    }
  }

  const TopologyGraph& graph_;
  std::map<VertexId, std::vector<HalfEdgeId>> ways_;
  std::map<VertexId, Way> best_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open_;
};

}  // namespace

InnerPaths innerPaths(const TopologyGraph& graph, const std::vector<EdgeId>& edges,
                      const std::vector<VertexId>& ends, Point center, double minClearance) {
  PlaceOnPath start = nearestPlace(graph, edges, center, minClearance);
  if (!start.edge) start = nearestPlace(graph, edges, center, 0);
  if (!start.edge) start = middleOfLongest(graph, edges);
  const Path& startPath = graph.edge(start.edge).path;
  const ShortestWays ways(graph, edges, start);
  InnerPaths result;
  result.center = placeOn(startPath, start.along);
  result.clearance = clearanceAt(startPath, start.along);
  for (const VertexId end : ends) result.paths.push_back(ways.pathTo(end));
  return result;
}

}  // namespace roomgraph
