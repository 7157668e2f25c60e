#include "roomgraph/rooms/hall_ways.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "HallGraph.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/grid/polygon_cells.h"
#include "straight_ways.h"

namespace roomgraph {
namespace {

constexpr double kFarFloor = 3;  // from a way, where another one is missing [m]
constexpr double kDetour = 1.3;  // the longest way round, over the straight one
/** What lengthens a way between two by less than this is nearly between them. */
const double kNearly = std::sqrt(kDetour);

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
        ways_(std::move(ways), room, obstacles) {}

  TopologyGraph build() && {
    const std::size_t given = ways_.size();
    closeLoops(0);
    reachPlaces();
    closeLoops(given);
    return std::move(ways_).take();
  }

 private:
  /** A way between two: along the ways out of both, if border vertices, and straight between. */
  struct Link {
    double length;
    VertexId a, b;
    Point turnA, turnB;  // where it leaves these ways
  };

  /** From each vertex to those from `first` on: what lies between the others is known by then. */
  void closeLoops(std::size_t first) {
    std::vector<Link> links = missingLinks(first);
    std::sort(links.begin(), links.end(), [](const Link& l, const Link& r) {
      return std::tie(l.length, l.a, l.b) < std::tie(r.length, r.a, r.b);
    });
    for (const Link& link : links)
      if (isMissing(link.length, ways_.lengthsFrom(link.a, longest(link.length))[link.b.index()]))
        ways_.addStraight(link.turnA, link.turnB);
  }

  /** How long ways may be between places so far apart: no more than what is far is not missed. */
  static double longest(double shortest) {
    return std::max(kDetour * shortest, shortest + kFarFloor);
  }
  static bool isMissing(double shortest, double length) { return length > longest(shortest); }

  std::vector<Link> missingLinks(std::size_t first) const {
    std::vector<Link> links;
    for (std::size_t v = 0; v < ways_.size(); ++v) {
      const VertexId a(v);
      const std::vector<VertexId> others = neighboursOf(a);
      double most = ways_.isBorder(a) ? HUGE_VAL : 0;
      for (const VertexId b : others)
        most = std::max(most, longest(distance(ways_.placeOf(a), ways_.placeOf(b))));
      const std::vector<double> lengthsTo = ways_.lengthsFrom(a, most);
      for (const VertexId b : others)
        if (std::max(a, b).index() >= first)
          addLink(links, std::min(a, b), std::max(a, b), lengthsTo[b.index()]);
    }
    return links;
  }

  /** Those that a way may be missing to; of two, one has the other. Doors all with all; of others
   *  those with none nearly between them, where one way leads to both. */
  std::vector<VertexId> neighboursOf(VertexId a) const {
    std::vector<VertexId> found;
    const std::vector<Near> near = nearOf(a);
    for (const auto& [away, b] : near) {
      const bool isOurs = ways_.isBorder(a) ? !ways_.isBorder(b) : !ways_.isBorder(b) && a < b;
      if (isOurs && !isBlocked(away, b, near)) found.push_back(b);
    }
    for (std::size_t b = a.index() + 1; ways_.isBorder(a) && b < ways_.size(); ++b)
      if (ways_.isBorder(VertexId(b))) found.push_back(VertexId(b));
    return found;
  }

  using Near = std::pair<double, VertexId>;  // how far away a vertex is, and which it is

  /** All that count beside the nearest one, which is nearly between this one and any that is
   *  farther away; the nearest first. */
  std::vector<Near> nearOf(VertexId a) const {
    std::vector<Near> near;
    for (std::size_t b = 0; b < ways_.size(); ++b)
      if (const double away = distance(ways_.placeOf(a), ways_.placeOf(VertexId(b))); away > 0)
        near.push_back({away, VertexId(b)});
    if (near.empty()) return near;
    const double least = std::min_element(near.begin(), near.end())->first;
    const double most = 2 / (kNearly - 1) * least;
    eraseIf(near, [&](const Near& n) { return n.first > kNearly * most; });
    std::sort(near.begin(), near.end());
    return near;
  }

  /** Whether one of those near a vertex is nearly between it and another one of them. */
  bool isBlocked(double away, VertexId b, const std::vector<Near>& near) const {
    const Point to = ways_.placeOf(b);
    return anyOf(near, [&](const Near& n) {
      const Point place = ways_.placeOf(n.second);
      return place != to && n.first + distance(place, to) < kNearly * away;
    });
  }

  /** The shortest that is clear, if any is that much shorter than the ways there are. A door may
   *  lie too far aside of the open floor for a straight way. */
  void addLink(std::vector<Link>& links, VertexId a, VertexId b, double length) const {
    const int borderCount = ways_.isBorder(a) + ways_.isBorder(b);
    for (double along = 0; along == 0 || borderCount > 0; along += kFarFloor / 8) {
      const Point turnA = ways_.onTheWayFrom(a, along), turnB = ways_.onTheWayFrom(b, along);
      const double shortest = borderCount * along + distance(turnA, turnB);
      if (!isMissing(shortest, length)) return;
      if (isClear(turnA, turnB)) return links.push_back({shortest, a, b, turnA, turnB});
    }
  }

  void reachPlaces() {
    std::vector<Place> places = openFloor();
    for (const Edge& edge : ways_.edges()) bringNearer(places, edge.path);
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
      if (isClear(place.way, place.floor))
        bringNearer(places, ways_.addDeadEnd(place.way, place.floor));
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
    eraseIf(places, [](const Place& place) { return place.farSquared <= kFarFloor * kFarFloor; });
  }

  bool isClear(Point a, Point b) const {
    const Point middle = midpoint(a, b);
    return obstacles_.isClear(a, b, minClearance_) && index_.roomAt(middle) &&
           !leavesRoom(index_, middle, a, 2 * minClearance_) &&
           !leavesRoom(index_, middle, b, 2 * minClearance_);
  }

  const Room& room_;
  const RoomIndex index_;
  const ObstacleRows& obstacles_;
  double minClearance_;
  HallGraph ways_;
};

}  // namespace

TopologyGraph hallWays(TopologyGraph ways, const Room& room, const ObstacleRows& obstacles,
                       double minClearance) {
  if (room.inscribedRadius <= kFarFloor || ways.edges().empty()) return ways;
  return Hall(std::move(ways), room, obstacles, minClearance).build();
}

}  // namespace roomgraph
