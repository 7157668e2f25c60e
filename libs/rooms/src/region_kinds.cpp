#include "region_kinds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/geometry/Polygon.h"

namespace roomgraph {
namespace {

/** Closer ones lie on one side of it: there is a branch of the diagram into each dent of a wall. */
constexpr double kOneSide = 0.5;

/** Of a region in its convex hull; corridors with a bend or a branch have less. */
constexpr double kLeastSolidity = 2.0 / 3;

/** What lies beside a part of a way between two walls that face each other. */
struct Stretch {
  double width, area;
};

/** All of one region. */
struct Stretches {
  std::vector<Stretch> facing;
  double facingArea = 0, area = 0;
};

/** The mean width of the largest part of a region's stretches that is about as wide everywhere;
 *  infinity if that is less than half of its area. */
double mainWidth(Stretches& of) {
  double largest = of.area / 2, width = std::numeric_limits<double>::infinity();
  if (of.facingArea <= largest) return width;
  std::sort(of.facing.begin(), of.facing.end(), [](const Stretch& p, const Stretch& q) {
    return std::tie(p.width, p.area) < std::tie(q.width, q.area);
  });
  double area = 0, sum = 0;  // from low to high
  for (auto low = of.facing.begin(), high = low; high != of.facing.end(); ++high) {
    area += high->area, sum += high->area * high->width;
    for (; low->width * std::sqrt(2.0) < high->width; ++low)
      area -= low->area, sum -= low->area * low->width;
    if (area > largest) largest = area, width = sum / area;
  }
  return width;
}

using Neighbours = RegionGroups::Neighbours;

/** The same as kLongerThanOthers where ways out are no doors, or it is wide: a room round a core or
 *  between benches is as long as many a corridor. */
constexpr double kBlindElongation = 2.5;

bool hasLittleWall(const RegionGroups& regions, std::uint32_t region) {
  return regions.wallShare(region) < regions.options().minWallShare;
}

/** Those that a way out leads to: through a window beams go, but nobody else. */
Neighbours seenOnes(const RegionGroups& regions, Neighbours around) {
  const auto isUnseen = [&](const auto& way) { return hasLittleWall(regions, way.first); };
  eraseIf(around, isUnseen);
  return around;
}

/** Whether it is short, and all openings of it are narrow beside it; `exits` are its ways out. */
bool isBehindDoors(const RegionGroups& regions, std::uint32_t region, const Neighbours& around,
                   const Neighbours& exits) {
  double widest = 0;
  for (const auto& [other, passage] : around) widest = std::max(widest, passage.clearance);
  const double longest =
      regions.options().maxElongation * (exits.size() == 1 ? kLongerThanOthers : 1);
  return regions.elongation(region) <= longest &&
         widest < regions.options().maxRatio * regions.radius(region) * (1 - kSameWidth);
}

/** Whether doors close it that would part two pieces of corridor, too. */
bool isBehindNarrowDoors(const RegionGroups& regions, std::uint32_t region,
                         const Neighbours& around) {
  return allOf(around, [&](const auto& way) {
    const double clearance = way.second.clearance;
    return clearance <
               regions.options().corridorRatio * regions.radius(region) * (1 - kSameWidth) &&
           clearance < regions.options().corridorDoor / 2;
  });
}

/** The obstacles round some regions, by region. */
std::map<std::uint32_t, std::vector<Point>> cornersOf(RegionGroups& regions,
                                                      const std::vector<std::uint32_t>& some) {
  std::map<std::uint32_t, std::vector<Point>> corners;
  for (const std::uint32_t region : some) corners[region];
  if (some.empty()) return corners;
  const VoronoiGraph& voronoi = regions.voronoi();
  for (const VoronoiEdge& edge : voronoi.edges)
    for (const std::uint32_t end : {edge.source, edge.target}) {
      if (end == VoronoiEdge::kNoVertex || !regions.isInside()[end]) continue;
      const auto it = corners.find(regions.find(end));
      if (it == corners.end()) continue;
      for (const std::uint32_t obstacle : {edge.left, edge.right})
        it->second.push_back(voronoi.obstacles[obstacle]);
    }
  return corners;
}

/** Whether a region is long by what stands in it, as furniture or the bath of a hotel room: its
 *  convex hull is no longer than a room, and wide enough for two of its ways beside each other. */
bool isCompact(const RegionGroups& regions, std::uint32_t region, std::vector<Point> corners) {
  const Ring hull = convexHull(std::move(corners));
  const double width = leastWidth(hull) - 2 * regions.halfCell();
  const double solidity = regions.area(region) / signedArea(hull);
  return signedArea(hull) <= regions.options().maxElongation * width * width &&
         solidity >= kLeastSolidity && solidity * width >= 2 * regions.meanWidth(region);
}

/** Whether a narrow one has as much wall as a room has. Of what opens into corridors only, beams
 *  from there have seen a part. */
bool isSeenEnough(const RegionGroups& regions, std::uint32_t region, const Neighbours& exits) {
  const auto isLong = [&](const auto& way) { return regions.isLong(way.first); };
  return regions.wallShare(region) >= regions.options().minClosedShare ||
         (!exits.empty() && allOf(exits, isLong));
}

/** Whether it is no wider than a door may be, and opens with nearly its whole width on two sides.
 */
bool isWayThrough(const RegionGroups& regions, std::uint32_t region, const Neighbours& exits) {
  const double open = regions.options().maxRatio * regions.radius(region) * (1 - kSameWidth);
  int count = 0;
  for (const auto& [other, passage] : exits)
    for (const double clearance : {passage.clearance, passage.second})
      count += clearance >= open ? 1 : 0;
  return count > 1 && 2 * regions.radius(region) * (1 + kSameWidth) < regions.options().maxWidth;
}

/** Whether it is too narrow for a room; or narrow, and not closed by walls and doors; or a way
 *  through; or long with two ways out, or far longer than a room with one. `own` is its own width.
 */
bool isCorridor(const RegionGroups& regions, std::uint32_t region, const Neighbours& around,
                double own) {
  const double width = 2 * regions.radius(region) * (1 + kSameWidth);
  if (width < regions.options().minRoomWidth) return true;
  const Neighbours exits = seenOnes(regions, around);
  const bool isClosed =
      isSeenEnough(regions, region, exits) && isBehindDoors(regions, region, around, exits);
  if (regions.isNarrow(region) && !isClosed) return true;
  if (regions.elongation(region) < regions.options().minElongation) return true;
  if (isWayThrough(regions, region, exits)) return true;
  int count = 0;
  for (const auto& [other, passage] : exits) count += passage.count;
  // What furniture leaves of a room behind one door is narrow: so that goes by its largest disc.
  const bool isLong =
      count > 1 ? regions.area(region) > regions.options().maxElongation * own * own
                : regions.elongation(region) > regions.options().maxElongation * kBlindElongation;
  return isLong && own * (1 + kSameWidth) <= regions.options().maxCorridorWidth;
}

class KindFinder {
 public:
  KindFinder(RegionGroups& regions, const std::vector<double>& widths)
      : regions_(regions),
        widths_(widths),
        around_(regions.neighbours()),
        kinds_(regions.isInside().size(), RegionKind::corridor) {}

  std::vector<RegionKind> run() {
    findCompactRooms();
    regions_.eachRegion([&](std::uint32_t region) { kinds_[region] = kindOf(region); });
    return std::move(kinds_);
  }

 private:
  const Neighbours& around(std::uint32_t region) const {
    static const Neighbours kNobody;
    const auto it = std::lower_bound(around_.begin(), around_.end(), region,
                                     [](const auto& l, std::uint32_t r) { return l.first < r; });
    return it == around_.end() || it->first != region ? kNobody : it->second;
  }

  /** Of those that are wide enough, and would be corridor for their length. */
  void findCompactRooms() {
    std::vector<std::uint32_t> closed;
    regions_.eachRegion([&](std::uint32_t region) {
      if (isLongBehindDoors(region)) closed.push_back(region);
    });
    for (auto& [region, corners] : cornersOf(regions_, closed))
      if (isCompact(regions_, region, std::move(corners))) compact_.insert(region);
  }

  bool isLongBehindDoors(std::uint32_t region) const {
    const double width = widths_[region];
    return 2 * regions_.radius(region) * (1 + kSameWidth) >= regions_.options().minRoomWidth &&
           regions_.area(region) > regions_.options().maxElongation * width * width &&
           regions_.wallShare(region) >= regions_.options().minClosedShare &&
           isBehindNarrowDoors(regions_, region, around(region));
  }

  RegionKind kindOf(std::uint32_t region) const {
    if (hasLittleWall(regions_, region)) return RegionKind::halfSeen;
    if (compact_.count(region) > 0) return RegionKind::room;
    return isCorridor(regions_, region, around(region), widths_[region]) ? RegionKind::corridor
                                                                         : RegionKind::room;
  }

  RegionGroups& regions_;
  const std::vector<double>& widths_;
  const RegionGroups::AllNeighbours around_;
  std::set<std::uint32_t> compact_;  // rooms, however long
  std::vector<RegionKind> kinds_;
};

}  // namespace

std::vector<double> ownWidths(RegionGroups& regions, const std::vector<std::uint8_t>& isWall) {
  const VoronoiGraph& voronoi = regions.voronoi();
  std::vector<Stretches> stretches(voronoi.vertices.size());
  regions.eachStretch([&](const VoronoiEdge& edge, std::uint32_t end, double area) {
    const double width = voronoi.vertices[end].clearance + edge.minClearance;
    const double apart = norm(voronoi.obstacles[edge.right] - voronoi.obstacles[edge.left]);
    if (apart < kOneSide * width) return;
    Stretches& of = stretches[regions.find(end)];
    of.area += area;
    if (apart < kFacing * width || !isWall[edge.left] || !isWall[edge.right]) return;
    of.facing.push_back({std::max(0.0, width - 2 * regions.halfCell()), area});
    of.facingArea += area;
  });
  std::vector<double> widths(voronoi.vertices.size());
  for (std::uint32_t v = 0; v < widths.size(); ++v)
    widths[v] = std::min(2 * regions.radius(v), mainWidth(stretches[v]));
  return widths;
}

std::vector<RegionKind> regionKinds(RegionGroups& regions, const std::vector<double>& widths) {
  return KindFinder(regions, widths).run();
}

}  // namespace roomgraph
