#include "roomgraph/rooms/trace_rooms.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace roomgraph {
namespace {

constexpr std::uint32_t kNone = Regions::kNone;

/** A Delaunay edge on the boundary of a room, which lies on its left. */
struct BoundaryEdge {
  std::uint32_t room, from, to;  // from and to are obstacles
  bool isUsed = false;
};

std::vector<BoundaryEdge> boundaryEdges(const VoronoiGraph& voronoi, const Regions& regions) {
  std::vector<BoundaryEdge> boundary;
  for (const VoronoiEdge& edge : voronoi.edges) {
    const auto source = regions.of(edge.source), target = regions.of(edge.target);
    // The disc of the alpha shape parts rooms, not corridors.
    if (source == target && (source >= regions.roomCount || edge.minClearance > regions.radius))
      continue;
    if (source != kNone) boundary.push_back({source, edge.right, edge.left});
    if (target != kNone) boundary.push_back({target, edge.left, edge.right});
  }
  std::sort(boundary.begin(), boundary.end(), [](const BoundaryEdge& a, const BoundaryEdge& b) {
    return std::tie(a.from, a.room, a.to) < std::tie(b.from, b.room, b.to);
  });
  return boundary;
}

/** How far to turn clockwise from one direction to the other, in (0, 2 pi]. */
double clockwiseTurn(Point from, Point to) {
  const double turn = std::atan2(cross(to, from), dot(to, from));
  return turn > 0 ? turn : turn + 2 * M_PI;
}

class RingTracer {
 public:
  RingTracer(const VoronoiGraph& voronoi, std::vector<BoundaryEdge> boundary)
      : obstacles_(voronoi.obstacles),
        boundary_(std::move(boundary)),
        firstFrom_(obstacles_.size() + 1),
        place_(obstacles_.size(), kNone) {
    for (const BoundaryEdge& edge : boundary_) ++firstFrom_[edge.from + 1];
    for (std::size_t i = 0; i < obstacles_.size(); ++i) firstFrom_[i + 1] += firstFrom_[i];
  }

  /** Calls `add(room, ring)` for every simple ring of every room. */
  template <class Add>
  void run(const Add& add) {
    for (BoundaryEdge& first : boundary_)
      if (!first.isUsed)
        splitAtTouches(walk(first), [&](const Ring& ring) { add(first.room, ring); });
  }

 private:
  std::vector<std::uint32_t> walk(BoundaryEdge& first) {
    std::vector<std::uint32_t> ring;
    for (BoundaryEdge* edge = &first; edge; edge = next(*edge)) {
      edge->isUsed = true;
      ring.push_back(edge->from);
    }
    return ring;
  }

  /** The next edge round the same piece of the room; null where the ring closes. */
  BoundaryEdge* next(const BoundaryEdge& edge) {
    BoundaryEdge* best = nullptr;
    double leastTurn = 7;
    const Point back = obstacles_[edge.from] - obstacles_[edge.to];
    for (std::size_t i = firstFrom_[edge.to]; i < firstFrom_[edge.to + 1]; ++i) {
      BoundaryEdge& other = boundary_[i];
      if (other.isUsed || other.room != edge.room) continue;
      const double turn = clockwiseTurn(back, obstacles_[other.to] - obstacles_[other.from]);
      if (turn < leastTurn) {
        leastTurn = turn;
        best = &other;
      }
    }
    return best;
  }

  /** A walk that comes by an obstacle twice is cut there. What encloses no area, a wall one
   *  obstacle thick that reaches into the room, is dropped, as the regularised alpha shape does. */
  template <class Add>
  void splitAtTouches(const std::vector<std::uint32_t>& walk, const Add& add) {
    std::vector<std::uint32_t> open;
    const auto close = [&](std::size_t from) {
      Ring ring;
      for (std::size_t i = from; i < open.size(); ++i) {
        ring.push_back(obstacles_[open[i]]);
        place_[open[i]] = kNone;
      }
      open.resize(from);
      if (ring.size() > 2) add(ring);
    };
    for (const auto obstacle : walk) {
      if (place_[obstacle] != kNone) close(place_[obstacle]);
      place_[obstacle] = std::uint32_t(open.size());
      open.push_back(obstacle);
    }
    close(0);
  }

  const std::vector<Point>& obstacles_;
  std::vector<BoundaryEdge> boundary_;
  std::vector<std::uint32_t> firstFrom_;  // per obstacle into boundary_
  std::vector<std::uint32_t> place_;      // of an obstacle in the open ring
};

}  // namespace

Rooms traceRegions(const VoronoiGraph& voronoi, const Regions& regions) {
  Rooms rooms(regions.count);
  for (std::uint32_t r = 0; r < regions.count; ++r) rooms[r].region = r;
  for (std::uint32_t v = 0; v < regions.regionOf.size(); ++v) {
    if (regions.regionOf[v] == kNone) continue;
    Room& room = rooms[regions.regionOf[v]];
    const VoronoiVertex& vertex = voronoi.vertices[v];
    if (vertex.clearance <= room.inscribedRadius) continue;
    room.inscribedRadius = vertex.clearance;
    room.widestPlace = vertex.at;
  }
  RingTracer(voronoi, boundaryEdges(voronoi, regions))
      .run([&](std::uint32_t room, const Ring& ring) {
        Polygon& polygon = rooms[room].polygon;
        if (signedArea(ring) > signedArea(polygon.outer))
          polygon.outer = ring;
        else
          polygon.holes.push_back(ring);
      });
  return rooms;
}

Rooms traceRooms(const VoronoiGraph& voronoi, const Regions& regions) {
  Rooms rooms = traceRegions(voronoi, regions);
  rooms.resize(regions.roomCount);
  return rooms;
}

}  // namespace roomgraph
