#include "find_halls.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "roomgraph/rooms/trace_rooms.h"

namespace roomgraph {
namespace {

/** One island has a ring corridor round it. */
constexpr std::size_t kFewestIslands = 2;

/** The holes of a region that none of the others lies in. */
std::vector<const Ring*> islandsOf(const Room& room, const Rooms& all) {
  std::vector<const Ring*> islands;
  for (const Ring& hole : room.polygon.holes) {
    const Polygon inside{hole, {}};
    const auto isIn = [&](const Room& other) {
      return &other != &room && sideOf(inside, other.widestPlace) == Side::inside;
    };
    if (std::none_of(all.begin(), all.end(), isIn)) islands.push_back(&hole);
  }
  return islands;
}

/** How far the innermost corner of an island is from the outer ring [m]. */
double depthOf(const Ring& outer, const std::vector<const Ring*>& islands) {
  double deepest = 0;
  for (const Ring* island : islands)
    for (const Point corner : *island) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Point wall : outer) nearest = std::min(nearest, squaredNorm(wall - corner));
      deepest = std::max(deepest, nearest);
    }
  return std::sqrt(deepest);
}

bool isHall(const Room& room, const Rooms& all, const SplitAtDoorsOptions& options) {
  if (room.polygon.holes.size() < kFewestIslands) return false;
  const std::vector<const Ring*> islands = islandsOf(room, all);
  if (islands.size() < kFewestIslands) return false;
  double filled = 0;
  for (const Ring* island : islands) filled += std::abs(signedArea(*island));
  const double floor = area(room.polygon), width = 2 * depthOf(room.polygon.outer, islands);
  return filled <= floor && floor + filled <= options.maxElongation * width * width;
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
