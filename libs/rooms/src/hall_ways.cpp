#include "roomgraph/rooms/hall_ways.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "place_on_paths.h"
#include "roomgraph/geometry/intersect.h"
#include "roomgraph/grid/polygon_cells.h"
#include "straight_ways.h"

namespace roomgraph {
namespace {

constexpr double kFarFloor = 3;  // from a way, where another one is missing [m]
constexpr double kDetour = 1.3;  // the longest way round, over the straight one

/** A place of the open floor, and what of the ways is nearest to it. */
struct Place {
  Point floor, way;
  double farSquared = std::numeric_limits<double>::infinity();  // from there [m2]
};

class Hall {
 public:
  Hall(TopologyGraph ways, const Room& room, const ObstacleRows& obstacles, double minClearance)
      : room_(room),
        index_({room}, minClearance),
        obstacles_(obstacles),
        minClearance_(minClearance),
        vertices_(ways.vertices()),
        edges_(std::move(ways).takeEdges()) {}

  TopologyGraph build() && {
    const std::size_t given = vertices_.size();
    closeLoops(0);
    reachPlaces();
    closeLoops(given);
    return {std::move(vertices_), std::move(edges_)};
  }

 private:
  /** A way between two: along the ways out of both, if border vertices, and straight between. */
  struct Link {
    double length;
    VertexId a, b;
    Point turnA, turnB;  // where it leaves these ways
  };

  /** The ways, as Boost's search wants them. */
  using Lengths =
      boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                            boost::property<boost::edge_weight_t, double>>;

  /** From each vertex to those from `first` on: what lies between the others is known by then. */
  void closeLoops(std::size_t first) {
    Lengths lengths = lengthsOfAll();
    std::vector<Link> links = missingLinks(lengths, first);
    std::sort(links.begin(), links.end(), [](const Link& l, const Link& r) {
      return std::tie(l.length, l.a, l.b) < std::tie(r.length, r.a, r.b);
    });
    for (const Link& link : links) {
      if (!isMissing(link.length, lengthsFrom(link.a, lengths)[link.b.index()])) continue;
      addStraight(vertexAt(link.turnA), vertexAt(link.turnB));
      lengths = lengthsOfAll();
    }
  }

  /** Where the ways there are lead much farther round: by more than what is far, too. */
  static bool isMissing(double shortest, double length) {
    return length > std::max(kDetour * shortest, shortest + kFarFloor);
  }

  std::vector<Link> missingLinks(const Lengths& lengths, std::size_t first) const {
    std::vector<Link> links;
    for (std::size_t a = 0; a < vertices_.size(); ++a) {
      const std::vector<double> lengthsTo = lengthsFrom(VertexId(a), lengths);
      for (std::size_t b = std::max(first, a + 1); b < vertices_.size(); ++b)
        addLink(links, VertexId(a), VertexId(b), lengthsTo[b]);
    }
    return links;
  }

  /** Doors all with all; of others those with none nearly between them, where one way leads to
   *  both. */
  bool areNeighbours(VertexId a, VertexId b) const {
    if (isBorder(a) && isBorder(b)) return true;
    const Point from = placeOf(a), to = placeOf(b);
    const double between = std::sqrt(kDetour) * distance(from, to);
    return std::none_of(vertices_.begin(), vertices_.end(), [&](const Vertex& v) {
      return v.place != from && v.place != to &&
             distance(from, v.place) + distance(v.place, to) < between;
    });
  }

  /** The shortest that is clear, if any between neighbours is that much shorter than the ways there
   *  are. A door may lie too far aside of the open floor for a straight way. */
  void addLink(std::vector<Link>& links, VertexId a, VertexId b, double length) const {
    const int borderCount = isBorder(a) + isBorder(b);
    for (double along = 0; along == 0 || borderCount > 0; along += kFarFloor / 8) {
      const Point turnA = onTheWayFrom(a, along), turnB = onTheWayFrom(b, along);
      const double shortest = borderCount * along + distance(turnA, turnB);
      if (!isMissing(shortest, length) || (along == 0 && !areNeighbours(a, b))) return;
      if (isClear(turnA, turnB)) return links.push_back({shortest, a, b, turnA, turnB});
    }
  }

  Point onTheWayFrom(VertexId v, double along) const {
    if (!isBorder(v)) return placeOf(v);
    for (const Edge& edge : edges_) {
      const double there = std::min(along, edge.path.length);
      if (edge.source == v) return placeOn(edge.path, there);
      if (edge.target == v) return placeOn(edge.path, edge.path.length - there);
    }
    return placeOf(v);
  }

  Lengths lengthsOfAll() const {
    Lengths lengths(vertices_.size());
    for (const Edge& edge : edges_)
      add_edge(edge.source.index(), edge.target.index(), edge.path.length, lengths);
    return lengths;
  }

  /** Along the ways, by vertex; as long as can be where none leads. */
  static std::vector<double> lengthsFrom(VertexId start, const Lengths& lengths) {
    std::vector<double> lengthsTo(num_vertices(lengths));
    dijkstra_shortest_paths(lengths, start.index(), boost::distance_map(lengthsTo.data()));
    return lengthsTo;
  }

  void reachPlaces() {
    std::vector<Place> places = openFloor();
    for (const Edge& edge : edges_) bringNearer(places, edge.path);
    const Point middle = centroid(room_.polygon);
    const auto rank = [&](const Place& place) {
      return std::tuple(place.farSquared, distance(place.floor, middle), place.floor.x,
                        place.floor.y);
    };
    while (!places.empty()) {
      const auto farthest =
          std::max_element(places.begin(), places.end(),
                           [&](const Place& l, const Place& r) { return rank(l) < rank(r); });
      const Place place = *farthest;
      places.erase(farthest);
      if (isClear(place.way, place.floor)) bringNearer(places, addPlace(place));
    }
  }

  /** Squares round the centroid, so that they turn with the map; but not those at walls, which
   *  ways beside them reach. */
  std::vector<Place> openFloor() const {
    const double side = kFarFloor / 2;
    const Point middle = centroid(room_.polygon);
    const Box box = boundingBox(room_.polygon.outer);
    const double left = std::floor((middle.x - box.low.x) / side);
    const double below = std::floor((middle.y - box.low.y) / side);
    GridFrame frame;
    frame.resolution = side, frame.origin = middle - side * Point{left + 0.5, below + 0.5};
    frame.width = int((box.high.x - frame.origin.x) / side) + 1;
    frame.height = int((box.high.y - frame.origin.y) / side) + 1;
    std::vector<Place> places;
    for (const Cell cell : cellsIn(room_.polygon, frame)) {
      const Point point = middle + side * Point{cell.x - left, cell.y - below};
      if (obstacles_.isClear(point, point, side / 2)) places.push_back({point, {}});
    }
    return places;
  }

  /** Of the places those stay that are still far from any way. */
  static void bringNearer(std::vector<Place>& places, const Path& path) {
    const int steps = std::max(1, int(std::ceil(path.length / (kFarFloor / 4))));
    for (int i = 0; i <= steps; ++i) {
      const Point way = placeOn(path, i == steps ? path.length : i * path.length / steps);
      for (Place& place : places)
        if (const double far = squaredNorm(place.floor - way); far < place.farSquared)
          place.farSquared = far, place.way = way;
    }
    places.erase(std::remove_if(
                     places.begin(), places.end(),
                     [](const Place& place) { return place.farSquared <= kFarFloor * kFarFloor; }),
                 places.end());
  }

  Path addPlace(const Place& place) {
    const VertexId base = vertexAt(place.way);
    const VertexId tip(vertices_.size());
    vertices_.push_back({place.floor,
                         obstacles_.clearance(place.floor, place.floor, room_.inscribedRadius),
                         VertexKind::junction,
                         {}});
    addStraight(base, tip);
    kindOf(tip) = VertexKind::deadEnd;
    return straightPath(obstacles_, place.way, place.floor, 0);
  }

  /** Of the place on the ways that is nearest to a point. */
  VertexId vertexAt(Point point) {
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

  Point placeOf(VertexId v) const { return vertices_[v.index()].place; }
  VertexKind& kindOf(VertexId v) { return vertices_[v.index()].kind; }
  bool isBorder(VertexId v) const { return vertices_[v.index()].kind == VertexKind::border; }

  VertexId split(PlaceOnPath place) {
    const std::size_t count = vertices_.size();
    const VertexId v = splitAt(vertices_, edges_, place, VertexKind::junction);
    if (count == vertices_.size() || !edges_.back().path.obstacles.empty()) return v;
    vertices_.back().clearance =
        obstacles_.clearance(placeOf(v), placeOf(v), room_.inscribedRadius);
    for (Edge* part : {&edges_[place.edge.index()], &edges_.back()}) {
      Path& path = part->path;
      path.minClearance = vertices_.back().clearance;
      for (std::size_t i = 1; i < path.points.size(); ++i)
        path.minClearance =
            obstacles_.clearance(path.points[i - 1], path.points[i], path.minClearance);
    }
    return v;
  }

  bool isClear(Point a, Point b) const {
    const Point middle = midpoint(a, b);
    return obstacles_.isClear(a, b, minClearance_) && index_.roomAt(middle) &&
           !leavesRoom(index_, middle, a, 2 * minClearance_) &&
           !leavesRoom(index_, middle, b, 2 * minClearance_);
  }

  /** In pieces between the ways that it crosses. */
  void addStraight(VertexId from, VertexId to) {
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
    }
  }

  /** By edge, and then from its source on. */
  std::vector<std::pair<double, PlaceOnPath>> crossed(Point p, Point q) const {
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

  const Room& room_;
  const RoomIndex index_;
  const ObstacleRows& obstacles_;
  double minClearance_;
  std::vector<Vertex> vertices_;
  std::vector<Edge> edges_;
};

}  // namespace

TopologyGraph hallWays(TopologyGraph ways, const Room& room, const ObstacleRows& obstacles,
                       double minClearance) {
  if (room.inscribedRadius <= kFarFloor || ways.edges().empty()) return ways;
  return Hall(std::move(ways), room, obstacles, minClearance).build();
}

}  // namespace roomgraph
