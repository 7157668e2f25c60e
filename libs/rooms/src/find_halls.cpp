#include "find_halls.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/base/sequences.h"
#include "roomgraph/rooms/trace_rooms.h"

namespace roomgraph {
namespace {

/** One island has a ring corridor round it. */
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

bool isHall(const Room& room, const Rooms& all, const SplitAtDoorsOptions& options) {
  if (room.polygon.holes.size() < kFewestIslands) return false;
  const Surrounded by = surroundedBy(room, all, options.maxLeftoverArea);
  if (by.islands.size() < kFewestIslands) return false;
  double filled = area(room.polygon);
  for (const Ring* island : by.islands) {
    if (leastWidth(convexHull(*island)) > 2 * room.inscribedRadius) return false;
    filled += std::abs(signedArea(*island));
  }
  return areDeep(by, std::sqrt(filled / options.maxElongation) / 2);
}

}  // namespace

std::vector<std::uint8_t> findHalls(const VoronoiGraph& voronoi, const Regions& regions,
                                    const SplitAtDoorsOptions& options) {
  const Rooms shapes = traceRegions(voronoi, regions);
  std::vector<std::uint8_t> isOne(regions.count);
  for (std::uint32_t r = regions.roomCount; r < regions.seenCount; ++r)
    isOne[r] = isHall(shapes[r], shapes, options) ? 1 : 0;
  return isOne;
}

}  // namespace roomgraph
