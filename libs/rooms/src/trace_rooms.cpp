#include "roomgraph/rooms/trace_rooms.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

/** A Delaunay edge on the boundary of a room, which lies on its left. */
struct BoundaryEdge {
  std::uint32_t room = Regions::kNone, from = Regions::kNone,
                to = Regions::kNone;  // from and to are obstacles
  bool isUsed = false;
};

std::vector<BoundaryEdge> boundaryEdges(const VoronoiGraph& voronoi, const Regions& regions) {
  std::vector<BoundaryEdge> boundary;
  for (const VoronoiEdge& edge : voronoi.edges) {
    const auto source = regions.of(edge.source), target = regions.of(edge.target);
    // The disc of the alpha shape parts rooms, not corridors.
    if (source == target && (source >= regions.roomCount || edge.minClearance > regions.radius))
      continue;
    if (source != Regions::kNone) boundary.push_back({source, edge.right, edge.left});
    if (target != Regions::kNone) boundary.push_back({target, edge.left, edge.right});
  }
  return boundary;
}

/** How far to turn clockwise from one direction to the other, in (0, 2 pi]. */
double clockwiseTurn(Point from, Point to) {
  const double turn = std::atan2(cross(to, from), dot(to, from));
  return turn > 0 ? turn : turn + 2 * M_PI;
}

class RingTracer {
 public:
  RingTracer(const VoronoiGraph& voronoi, const std::vector<BoundaryEdge>& boundary)
      : obstacles_(voronoi.obstacles),
        boundary_(boundary.size()),
        firstFrom_(obstacles_.size() + 1),
        place_(obstacles_.size(), Regions::kNone) {
    for (const BoundaryEdge& edge : boundary) ++firstFrom_[edge.from + 1];
    std::partial_sum(firstFrom_.begin(), firstFrom_.end(), firstFrom_.begin());
    std::vector<std::uint32_t> next = firstFrom_;
    for (const BoundaryEdge& edge : boundary) boundary_[next[edge.from]++] = edge;
    for (std::size_t i = 0; i < obstacles_.size(); ++i) sortFrom(i);
  }

  /** Calls `add(room, ring)` for every simple ring of every room. */
  template <class Add>
  void run(const Add& add) {
    for (BoundaryEdge& first : boundary_)
      if (!first.isUsed) {
        walk(first);
        splitAtTouches([&](Ring ring) { add(first.room, std::move(ring)); });
      }
  }

 private:
  /** Those from one obstacle: the order must not depend on that of the diagram's edges. */
  void sortFrom(std::size_t obstacle) {
    const auto at = [&](std::size_t i) {
      return boundary_.begin() + std::ptrdiff_t(firstFrom_[i]);
    };
    std::sort(at(obstacle), at(obstacle + 1), [](const BoundaryEdge& a, const BoundaryEdge& b) {
      return std::tie(a.room, a.to) < std::tie(b.room, b.to);
    });
  }

  /** Notes the obstacles on the way round a piece of a room. */
  void walk(BoundaryEdge& first) {
    walk_.clear();
    for (BoundaryEdge* edge = &first; edge; edge = next(*edge)) {
      edge->isUsed = true;
      walk_.push_back(edge->from);
    }
  }

  /** The next edge round the same piece of the room; null where the ring closes. */
  BoundaryEdge* next(const BoundaryEdge& edge) {
    const Point back = obstacles_[edge.from] - obstacles_[edge.to];
    const auto turnTo = [&](const BoundaryEdge& other) {
      return clockwiseTurn(back, obstacles_[other.to] - obstacles_[other.from]);
    };
    BoundaryEdge* best = nullptr;
    for (std::size_t i = firstFrom_[edge.to]; i < firstFrom_[edge.to + 1]; ++i) {
      BoundaryEdge& other = boundary_[i];
      if (other.isUsed || other.room != edge.room) continue;
      if (!best || turnTo(other) < turnTo(*best)) best = &other;
    }
    return best;
  }

  /** A walk that comes by an obstacle twice is cut there. What encloses no area, a wall one
   *  obstacle thick that reaches into the room, is dropped, as the regularised alpha shape does. */
  template <class Add>
  void splitAtTouches(const Add& add) {
    std::vector<std::uint32_t>& open = open_;
    const auto close = [&](std::size_t from) {
      Ring ring;
      ring.reserve(open.size() - from);
      for (std::size_t i = from; i < open.size(); ++i) {
        ring.push_back(obstacles_[open[i]]);
        place_[open[i]] = Regions::kNone;
      }
      open.resize(from);
      if (ring.size() > 2) add(std::move(ring));
    };
    for (const auto obstacle : walk_) {
      if (place_[obstacle] != Regions::kNone) close(place_[obstacle]);
      place_[obstacle] = std::uint32_t(open.size());
      open.push_back(obstacle);
    }
    close(0);
  }

  const std::vector<Point>& obstacles_;
  std::vector<BoundaryEdge> boundary_;
  std::vector<std::uint32_t> firstFrom_;  // per obstacle into boundary_
  std::vector<std::uint32_t> walk_;       // obstacles on the way round a piece
  std::vector<std::uint32_t> open_;       // the ring that is not closed yet
  std::vector<std::uint32_t> place_;      // of an obstacle in the open ring
};

/** Finds the widest place of each region; of several as wide that nearest to its middle. */
void findWidest(const VoronoiGraph& voronoi, const Regions& regions, Rooms& rooms) {
  const auto middles = mapped(rooms, [](const Room& room) { return centroid(room.polygon); });
  for (std::uint32_t v = 0; v < regions.regionOf.size(); ++v) {
    if (regions.regionOf[v] == Regions::kNone) continue;
    Room& room = rooms[regions.regionOf[v]];
    const VoronoiVertex& vertex = voronoi.vertices[v];
    if (vertex.clearance < room.inscribedRadius * (1 - kSameWidth)) continue;
    const Point middle = middles[regions.regionOf[v]];
    if (vertex.clearance <= room.inscribedRadius * (1 + kSameWidth) &&
        distance(vertex.place, middle) >= distance(room.widestPlace, middle))
      continue;
    room.inscribedRadius = vertex.clearance;
    room.widestPlace = vertex.place;
  }
}

}  // namespace

Rooms traceRegions(const VoronoiGraph& voronoi, const Regions& regions) {
  Rooms rooms(regions.count);
  for (std::uint32_t r = 0; r < regions.count; ++r) {
    rooms[r].region = r;
    if (!regions.seen.empty()) rooms[r].seen = regions.seen[r];
  }
  std::vector<double> outerArea(regions.count);
  RingTracer(voronoi, boundaryEdges(voronoi, regions)).run([&](std::uint32_t room, Ring ring) {
    Polygon& polygon = rooms[room].polygon;
    const double area = signedArea(ring);
    if (area > outerArea[room]) {
      outerArea[room] = area;
      polygon.outer = std::move(ring);
    } else {
      polygon.holes.push_back(std::move(ring));
    }
  });
  findWidest(voronoi, regions, rooms);
  return rooms;
}

}  // namespace roomgraph
