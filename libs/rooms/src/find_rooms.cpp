#include "roomgraph/rooms/find_rooms.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "roomgraph/base/UnionFind.h"

namespace roomgraph {
namespace {

constexpr std::uint32_t kNone = VoronoiEdge::kNoVertex;

/** For each Voronoi vertex the number of its room, or kNone. */
struct RoomOfVertex {
  std::vector<std::uint32_t> room;
  std::uint32_t count = 0;

  std::uint32_t of(std::uint32_t vertex) const { return vertex == kNone ? kNone : room[vertex]; }
};

RoomOfVertex groupVertices(const VoronoiGraph& voronoi, const InsideFlags& isInside,
                           double radius) {
  const auto isWide = [&](std::uint32_t v) {
    return isInside[v] && voronoi.vertices[v].clearance > radius;
  };
  UnionFind groups(voronoi.vertices.size());
  for (const VoronoiEdge& edge : voronoi.edges)
    if (edge.minClearance > radius && !edge.isInfinite() && isWide(edge.source) &&
        isWide(edge.target))
      groups.join(edge.source, edge.target);
  RoomOfVertex rooms{std::vector<std::uint32_t>(voronoi.vertices.size(), kNone), 0};
  for (std::uint32_t v = 0; v < rooms.room.size(); ++v) {
    if (!isWide(v)) continue;
    // The smallest vertex of a group comes first.
    const std::uint32_t first = groups.find(v);
    rooms.room[v] = first == v ? rooms.count++ : rooms.room[first];
  }
  return rooms;
}

/** A Delaunay edge on the boundary of a room, which lies on its left. */
struct BoundaryEdge {
  std::uint32_t room, from, to;  // from and to are sites
  bool isUsed = false;
};

std::vector<BoundaryEdge> boundaryEdges(const VoronoiGraph& voronoi, const RoomOfVertex& rooms,
                                        double radius) {
  std::vector<BoundaryEdge> boundary;
  for (const VoronoiEdge& edge : voronoi.edges) {
    const auto source = rooms.of(edge.source), target = rooms.of(edge.target);
    if (source == target && (source == kNone || edge.minClearance > radius)) continue;
    if (source != kNone) boundary.push_back({source, edge.right, edge.left});
    if (target != kNone) boundary.push_back({target, edge.left, edge.right});
  }
  std::sort(boundary.begin(), boundary.end(), [](const BoundaryEdge& a, const BoundaryEdge& b) {
    return std::tie(a.room, a.from, a.to) < std::tie(b.room, b.from, b.to);
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
      : sites_(voronoi.sites), boundary_(std::move(boundary)), place_(sites_.size(), kNone) {}

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
    const BoundaryEdge key{edge.room, edge.to, 0};
    auto it = std::lower_bound(boundary_.begin(), boundary_.end(), key,
                               [](const BoundaryEdge& a, const BoundaryEdge& b) {
                                 return std::tie(a.room, a.from) < std::tie(b.room, b.from);
                               });
    BoundaryEdge* best = nullptr;
    double leastTurn = 7;
    const Point back = sites_[edge.from] - sites_[edge.to];
    for (; it != boundary_.end() && it->room == edge.room && it->from == edge.to; ++it) {
      if (it->isUsed) continue;
      const double turn = clockwiseTurn(back, sites_[it->to] - sites_[it->from]);
      if (turn < leastTurn) {
        leastTurn = turn;
        best = &*it;
      }
    }
    return best;
  }

  /** A walk that comes by a site twice is cut there. What encloses no area, a wall one obstacle
   *  thick that reaches into the room, is dropped, as the regularised alpha shape does. */
  template <class Add>
  void splitAtTouches(const std::vector<std::uint32_t>& walk, const Add& add) {
    std::vector<std::uint32_t> open;
    const auto close = [&](std::size_t from) {
      Ring ring;
      for (std::size_t i = from; i < open.size(); ++i) {
        ring.push_back(sites_[open[i]]);
        place_[open[i]] = kNone;
      }
      open.resize(from);
      if (ring.size() > 2) add(ring);
    };
    for (const auto site : walk) {
      if (place_[site] != kNone) close(place_[site]);
      place_[site] = std::uint32_t(open.size());
      open.push_back(site);
    }
    close(0);
  }

  const std::vector<Point>& sites_;
  std::vector<BoundaryEdge> boundary_;
  std::vector<std::uint32_t> place_;  // of a site in the open ring
};

}  // namespace

void describe(FindRoomsOptions& options, FieldTable& table) {
  const char* section = "find_rooms";
  table.number(section, "min_width", options.minWidth, "m", 0.1, 100,
               "A room is where a disc of this diameter fits in everywhere.");
  table.number(section, "alpha_px2", options.alphaPx2, "px2", 0, 1e8,
               "The same as the paper's alpha, the disc's squared radius in cells; 0 for "
               "min_width.");
}

double roomRadius(const FindRoomsOptions& options, double resolution) {
  return options.alphaPx2 > 0 ? std::sqrt(options.alphaPx2) * resolution : options.minWidth / 2;
}

Rooms findRooms(const VoronoiGraph& voronoi, const InsideFlags& isInside, double radius) {
  const RoomOfVertex roomOf = groupVertices(voronoi, isInside, radius);
  Rooms rooms(roomOf.count);
  for (std::uint32_t v = 0; v < roomOf.room.size(); ++v) {
    if (roomOf.room[v] == kNone) continue;
    Room& room = rooms[roomOf.room[v]];
    const VoronoiVertex& vertex = voronoi.vertices[v];
    if (vertex.clearance <= room.inscribedRadius) continue;
    room.inscribedRadius = vertex.clearance;
    room.widestPlace = vertex.at;
  }
  RingTracer(voronoi, boundaryEdges(voronoi, roomOf, radius))
      .run([&](std::uint32_t room, const Ring& ring) {
        Polygon& polygon = rooms[room].polygon;
        if (signedArea(ring) > signedArea(polygon.outer))
          polygon.outer = ring;
        else
          polygon.holes.push_back(ring);
      });
  return rooms;
}

}  // namespace roomgraph
