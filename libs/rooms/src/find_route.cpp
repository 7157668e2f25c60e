#include "roomgraph/rooms/find_route.h"

#include <algorithm>
#include <limits>

#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/intersect.h"
#include "roomgraph/topology/shortest_ways.h"

namespace roomgraph {
namespace {

AreaId areaAt(const AreaGraph& areas, Point place) {
  for (std::size_t a = 0; a < areas.areas.size(); ++a)
    if (sideOf(areas.areas[a].polygon, place) != Side::outside) return AreaId(a);
  return AreaId::none();
}

/** Whether an area is closed all round, but for windows. */
bool isClosed(const AreaGraph& areas, AreaId area) {
  return !anyOf(areas.passages, [&](const Passage& passage) {
    return passage.b && (passage.a == area || passage.b == area);
  });
}

std::vector<EdgeId> allEdges(const TopologyGraph& graph) {
  std::vector<EdgeId> edges;
  for (std::size_t e = 0; e < graph.edges().size(); ++e) edges.push_back(EdgeId(e));
  return edges;
}

/** The piece of one edge, or the way over vertices. */
std::optional<Path> shortestPath(const TopologyGraph& graph, PlaceOnPath from, PlaceOnPath to,
                                 double minClearance) {
  const ShortestWays ways(graph, allEdges(graph), from, minClearance);
  const Edge& last = graph.edge(to.edge);
  std::optional<Path> best;
  const auto offer = [&](Path path) {
    if (path.minClearance < minClearance) return;
    if (!best || path.length < best->length) best = std::move(path);
  };
  if (from.edge == to.edge) {
    const Path between =
        piece(last.path, std::min(from.along, to.along), std::max(from.along, to.along));
    offer(from.along <= to.along ? between : reversed(between));
  }
  if (ways.reaches(last.source))
    offer(joined(ways.pathTo(last.source), piece(last.path, 0, to.along)));
  if (ways.reaches(last.target))
    offer(joined(ways.pathTo(last.target), reversed(piece(last.path, to.along, last.path.length))));
  return best;
}

/** Those that a polyline crosses, in its order. */
std::vector<PassageId> passagesAlong(const Polyline& points, const AreaGraph& areas) {
  std::vector<PassageId> found;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    std::vector<std::pair<double, PassageId>> met;
    for (std::size_t p = 0; p < areas.passages.size(); ++p)
      for (const double at :
           intersect(points[i], points[i + 1], areas.passages[p].from, areas.passages[p].to))
        met.push_back({at, PassageId(p)});
    std::sort(met.begin(), met.end());
    for (const auto& [at, passage] : met)
      if (found.empty() || found.back() != passage) found.push_back(passage);
  }
  return found;
}

}  // namespace

Whereabouts whereIs(const RoomGraph& graph, const AreaGraph& areas, Point place) {
  Whereabouts best;
  best.area = areaAt(areas, place);
  best.place = best.on = place;
  const bool staysInside = best.area && isClosed(areas, best.area);
  std::pair<bool, double> least{true, std::numeric_limits<double>::infinity()};
  for (std::size_t e = 0; e < graph.graph.edges().size(); ++e) {
    const Polyline& points = graph.graph.edges()[e].path.points;
    double along = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Point point = nearestOnSegment(place, points[i], points[i + 1]);
      const double off = distance(point, place);
      if (off < least.second || least.first) {
        const bool isElsewhere = best.area && areaAt(areas, point) != best.area;
        const bool isBehindWall = isElsewhere && staysInside;
        if (!isBehindWall && std::pair(isElsewhere, off) < least) {
          least = {isElsewhere, off};
          best.edge = EdgeId(e), best.along = along + distance(points[i], point), best.on = point;
        }
      }
      along += distance(points[i], points[i + 1]);
    }
  }
  return best;
}

std::optional<Route> findRoute(const RoomGraph& graph, const AreaGraph& areas,
                               const Whereabouts& from, const Whereabouts& to,
                               double minClearance) {
  if (!from.edge || !to.edge) return std::nullopt;
  const auto path =
      shortestPath(graph.graph, {from.edge, from.along}, {to.edge, to.along}, minClearance);
  if (!path) return std::nullopt;
  Route route{path->points, path->length, 0, path->minClearance, {}};
  const auto lead = [&](Polyline::iterator end, const Whereabouts& where) {
    if (where.place == where.on) return;
    route.points.insert(end, where.place);
    route.besideWays += distance(where.place, where.on);
  };
  lead(route.points.begin(), from);
  lead(route.points.end(), to);
  route.length += route.besideWays;
  route.passages = passagesAlong(route.points, areas);
  return route;
}

}  // namespace roomgraph
