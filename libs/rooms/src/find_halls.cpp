#include "find_halls.h"

#include <algorithm>
#include <cmath>

#include "region_kinds.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/rooms/trace_rooms.h"

namespace roomgraph {
namespace {

/** One island has a ring corridor round it, unless doors close that as a room. */
constexpr std::size_t kFewestIslands = 2;

/** What a region goes round. */
struct Surrounded {
  std::vector<const Ring*> islands;  // holes that no other region lies in
  Ring bounds;                       // the corners of all other rings, which bound it with these
};

/** Regions with less than `minArea` are what is free in the doubled side of an island. */
Surrounded surroundedBy(const Room& room, const Rooms& all, double minArea) {
  Surrounded found{{}, room.polygon.outer};
  for (const Ring& hole : room.polygon.holes) {
    const Polygon inside{hole, {}};
    const Box box = boundingBox(hole);
    const auto isIn = [&](const Room& other) {
      return box.contains(other.widestPlace) && &other != &room &&
             sideOf(inside, other.widestPlace) == Side::inside && area(other.polygon) >= minArea;
    };
    if (!anyOf(all, isIn))
      found.islands.push_back(&hole);
    else
      found.bounds.insert(found.bounds.end(), hole.begin(), hole.end());
  }
  return found;
}

/** Whether a corner of an island is so far from all that bounds them [m]. */
bool areDeep(const Surrounded& by, double far) {
  std::size_t near = 0;  // what is near one corner is near the next one, too
  for (const Ring* island : by.islands)
    for (const Point corner : *island) {
      std::size_t seen = 0;
      while (seen < by.bounds.size() && squaredNorm(by.bounds[near] - corner) >= far * far)
        ++seen, near = (near + 1) % by.bounds.size();
      if (seen == by.bounds.size()) return true;
    }
  return false;
}

/** Whether a region is closed by doors that would part two pieces of corridor, too, and would be as
 *  short as a room without what stands in it. `widest` is that of its openings. */
bool isClosedRoom(const Room& room, double widest, const SplitAtDoorsOptions& options) {
  const Ring hull = convexHull(room.polygon.outer);
  const double width = leastWidth(hull);
  const double disc = 2 * room.inscribedRadius;
  return disc >= options.minRoomWidth && width >= 2 * disc &&
         widest < std::min(options.corridorRatio * width, options.corridorDoor) &&
         hasRoomShape(std::abs(signedArea(room.polygon.outer)), hull, width, options);
}

bool isHall(const Room& room, const Rooms& all, double widest, const SplitAtDoorsOptions& options) {
  if (room.polygon.holes.empty()) return false;
  Surrounded by = surroundedBy(room, all, options.maxLeftoverArea);
  const bool isWithoutBlocks = by.islands.size() == room.polygon.holes.size();
  if (!isWithoutBlocks) by = surroundedBy(room, all, 0);
  double filled = area(room.polygon);
  for (const Ring* island : by.islands) {
    if (leastWidth(convexHull(*island)) > 2 * room.inscribedRadius) return false;
    filled += std::abs(signedArea(*island));
  }
  return (isWithoutBlocks && isClosedRoom(room, widest, options)) ||
         (by.islands.size() >= kFewestIslands &&
          areDeep(by, std::sqrt(filled / options.maxElongation) / 2));
}

/** The widest opening of each region [m]. */
std::vector<double> widestOpenings(const VoronoiGraph& voronoi, const Regions& regions,
                                   double halfCell) {
  std::vector<double> widest(regions.count);
  for (const VoronoiEdge& edge : voronoi.edges) {
    const std::uint32_t a = regions.of(edge.source), b = regions.of(edge.target);
    if (a == b || a == Regions::kNone || b == Regions::kNone) continue;
    for (const std::uint32_t region : {a, b})
      widest[region] = std::max(widest[region], 2 * (edge.minClearance - halfCell));
  }
  return widest;
}

}  // namespace

std::vector<std::uint8_t> findHalls(const VoronoiGraph& voronoi, const Regions& regions,
                                    double halfCell, const SplitAtDoorsOptions& options) {
  const Rooms shapes = traceRegions(voronoi, regions);
  const std::vector<double> widest = widestOpenings(voronoi, regions, halfCell);
  std::vector<std::uint8_t> isOne(regions.count);
  for (std::uint32_t r = regions.roomCount; r < regions.seenCount; ++r)
    isOne[r] = isHall(shapes[r], shapes, widest[r], options) ? 1 : 0;
  return isOne;
}

}  // namespace roomgraph
