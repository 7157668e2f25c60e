#include "find_halls.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/rooms/trace_rooms.h"

namespace roomgraph {
namespace {

/** One island has a ring corridor round it. */
constexpr std::size_t kFewestIslands = 2;

/** Of each region: some vertices of the diagram lie outside of their regions. */
std::vector<Point> widestPlaces(const VoronoiGraph& voronoi, const Regions& regions) {
  std::vector<Point> places(regions.count);
  std::vector<double> widest(regions.count, -1);
  for (std::uint32_t v = 0; v < regions.regionOf.size(); ++v) {
    const std::uint32_t region = regions.regionOf[v];
    if (region == Regions::kNone || voronoi.vertices[v].clearance <= widest[region]) continue;
    widest[region] = voronoi.vertices[v].clearance, places[region] = voronoi.vertices[v].place;
  }
  return places;
}

/** Without rooms and what is half seen. */
Regions corridorsOf(Regions regions) {
  for (std::uint32_t& region : regions.regionOf)
    if (region < regions.roomCount || region >= regions.seenCount) region = Regions::kNone;
  return regions;
}

/** The holes of a region that no other lies in. */
std::vector<const Ring*> islandsOf(const Room& room, const std::vector<Point>& places) {
  std::vector<const Ring*> islands;
  for (const Ring& hole : room.polygon.holes) {
    const Polygon inside{hole, {}};
    const Box box = boundingBox(hole);
    const auto isIn = [&](Point place) {
      return box.contains(place) && sideOf(inside, place) == Side::inside;
    };
    if (std::none_of(places.begin(), places.end(), isIn)) islands.push_back(&hole);
  }
  return islands;
}

/** Whether a corner of an island is so far from the outer ring [m]. */
bool areDeep(const std::vector<const Ring*>& islands, const Ring& outer, double far) {
  std::size_t near = 0;  // what is near one corner is near the next one, too
  for (const Ring* island : islands)
    for (const Point corner : *island) {
      std::size_t seen = 0;
      while (seen < outer.size() && squaredNorm(outer[near] - corner) >= far * far)
        ++seen, near = (near + 1) % outer.size();
      if (seen == outer.size()) return true;
    }
  return false;
}

bool isHall(const Room& room, const std::vector<Point>& places,
            const SplitAtDoorsOptions& options) {
  if (room.polygon.holes.size() < kFewestIslands) return false;
  const std::vector<const Ring*> islands = islandsOf(room, places);
  if (islands.size() < kFewestIslands) return false;
  double filled = area(room.polygon);
  for (const Ring* island : islands) {
    if (leastWidth(convexHull(*island)) > 2 * room.inscribedRadius) return false;
    filled += std::abs(signedArea(*island));
  }
  return areDeep(islands, room.polygon.outer, std::sqrt(filled / options.maxElongation) / 2);
}

}  // namespace

std::vector<std::uint8_t> findHalls(const VoronoiGraph& voronoi, const Regions& regions,
                                    const SplitAtDoorsOptions& options) {
  const Rooms corridors = traceRegions(voronoi, corridorsOf(regions));
  const std::vector<Point> places = widestPlaces(voronoi, regions);
  std::vector<std::uint8_t> isOne(regions.count);
  for (std::uint32_t r = regions.roomCount; r < regions.seenCount; ++r)
    isOne[r] = isHall(corridors[r], places, options) ? 1 : 0;
  return isOne;
}

}  // namespace roomgraph
