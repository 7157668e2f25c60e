#include "follow_corridors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "goes_on.h"
#include "join_leftovers.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

/** Two ways out of a region lie on one side of it where they turn by less than a third of a
 *  half turn from each other: its cosine. */
constexpr double kSameSide = 0.5;

/** Those that lead on from a region, to corridor or to what may be a piece of it. */
struct Ways {
  std::vector<Point> directions;    // unit vectors out of it
  std::vector<Point> besidesDoors;  // the same without those through doors of a room
  bool areNarrow = true;            // each would be a door even between two pieces of corridor
};
using WaysOn = std::map<std::uint32_t, Ways>;  // by region

/** Whether a passage is a door even between two pieces of corridor. */
bool isDoorOfPieces(const RegionGroups& regions, double clearance, std::uint32_t a,
                    std::uint32_t b) {
  return isDoor(regions, clearance, a, b, regions.options().corridorRatio,
                regions.options().corridorDoor);
}

double narrower(const RegionGroups::Neighbours& two) {
  return std::min(two[0].second.clearance, two[1].second.clearance);
}

/** What is left over in the one door between two equal pieces would join both: it goes with the
 *  larger.
 *  Two such ways lead round an island, as a shelf in a hall. */
void keepDoors(RegionGroups& regions, const std::vector<RegionKind>& kinds) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> frames;
  const auto add = [&](std::uint32_t region, const RegionGroups::Neighbours& both) {
    const std::uint32_t a = both[0].first, b = both[1].first;
    if (kinds[region] == RegionKind::corridor && isDoorOfPieces(regions, narrower(both), a, b))
      frames[{a, b}].push_back(region);
  };
  eachDoorFrame(regions, kinds, RegionKind::corridor, add);
  for (const auto& [pieces, between] : frames)
    if (between.size() == 1)
      regions.join(between.front(), regions.larger(pieces.first, pieces.second));
}

/** A corridor is narrower at doors that open into it: those do not part it. What has no other way
 *  out than an opening in its side is no piece of it. */
void joinPieces(RegionGroups& regions, const std::vector<RegionKind>& kinds) {
  keepDoors(regions, kinds);
  const RegionGroups::AllNeighbours all = regions.neighbours();
  std::vector<std::uint8_t> mayBeOne(kinds.size());
  for (const auto& [region, around] : all)
    mayBeOne[region] = kinds[region] == RegionKind::corridor &&
                       (around.size() > 1 || !around.front().second.isOffCorridor);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pieces;  // all before any is joined
  for (const auto& [region, around] : all)
    for (const auto& [other, passage] : around)
      if (mayBeOne[region] && mayBeOne[other] && !passage.isFront &&
          !isDoorOfPieces(regions, passage.clearance, region, other))
        pieces.push_back({region, other});
  for (const auto& [region, other] : pieces) regions.join(region, other);
}

/** Narrower than halls are: the wider it is, the longer it has to be. */
bool hasCorridorWidth(const RegionGroups& regions, std::uint32_t region) {
  const double length = std::min(1.0, regions.elongation(region) / regions.options().maxElongation);
  const double widest =
      std::max(regions.options().maxWidth, regions.options().maxCorridorWidth * length);
  return 2 * regions.radius(region) * (1 + kSameWidth) < widest;
}

/** Rooms that may be pieces of a corridor by their width. */
std::vector<std::uint32_t> narrowRooms(RegionGroups& regions,
                                       const std::vector<RegionKind>& kinds) {
  std::vector<std::uint32_t> narrow;
  regions.eachRegion([&](std::uint32_t region) {
    if (kinds[region] == RegionKind::room && hasCorridorWidth(regions, region))
      narrow.push_back(region);
  });
  return narrow;
}

/** Rooms in a row that only pilasters or cabinets part: those are pieces of a corridor where they
 *  are as long as one together, though none of them is by itself. */
class Chains {
 public:
  Chains(RegionGroups& regions, const std::vector<RegionKind>& kinds)
      : regions_(regions),
        chains_(kinds.size()),
        links_(narrowRooms(regions, kinds)),
        isLink_(kinds.size()) {
    for (const std::uint32_t region : links_) isLink_[region] = 1;
  }

  /** Those that are pieces of a corridor. */
  std::vector<std::uint32_t> find() && {
    for (const auto& [region, around] : regions_.neighbours()) {
      for (const auto& [other, passage] : around)
        if (!passage.isFront && areLinked(region, other, passage.clearance))
          chains_.join(region, other);
      // Between pilasters that are thick, and two equal pieces, a leftover belongs to neither.
      if (around.size() == 2 && regions_.elongation(region) < regions_.options().minElongation &&
          areLinked(around[0].first, around[1].first, narrower(around)))
        chains_.join(around[0].first, around[1].first);
    }
    std::vector<Chain> all(isLink_.size());
    for (const std::uint32_t region : links_) {
      Chain& chain = all[chains_.find(region)];
      ++chain.count;
      chain.area += regions_.area(region);
      chain.radius = std::max(chain.radius, regions_.radius(region));
    }
    const auto isShort = [&](std::uint32_t region) { return !isLong(all[chains_.find(region)]); };
    eraseIf(links_, isShort);
    return std::move(links_);
  }

 private:
  struct Chain {
    int count = 0;
    double area = 0, radius = 0;  // of all of it, and of its largest disc
  };

  /** Without a door between pieces of corridor, and about as wide: a crossing is a square. */
  bool areLinked(std::uint32_t a, std::uint32_t b, double clearance) const {
    const double narrow = std::min(regions_.radius(a), regions_.radius(b));
    const double wide = std::max(regions_.radius(a), regions_.radius(b));
    return isLink_[a] && isLink_[b] && wide <= narrow * std::sqrt(2.0) * (1 + kSameWidth) &&
           clearance >= regions_.options().corridorRatio * narrow * (1 - kSameWidth);
  }

  bool isLong(const Chain& chain) const {
    const double side = 2 * chain.radius;
    return chain.count > 1 &&
           chain.area > kLongerThanOthers * regions_.options().maxElongation * side * side;
  }

  RegionGroups& regions_;
  UnionFind chains_;
  std::vector<std::uint32_t> links_;
  std::vector<std::uint8_t> isLink_;  // per region
};

bool leadOnTwoSides(const std::vector<Point>& waysOn) {
  for (const Point p : waysOn)
    for (const Point q : waysOn)
      if (dot(p, q) < kSameSide) return true;
  return false;
}

/** Rooms that may be pieces of corridor, until what they lead to is known to be none. */
class Pieces {
 public:
  Pieces(RegionGroups& regions, const std::vector<RegionKind>& kinds, const Grid& grid)
      : regions_(regions),
        kinds_(kinds),
        grid_(grid),
        found_(narrowRooms(regions, kinds)),
        mayBe_(kinds.size()) {
    for (const std::uint32_t v : found_) mayBe_[v] = 1;
  }

  std::vector<std::uint32_t> find() && {
    while (dropOthers()) {
    }
    return std::move(found_);
  }

 private:
  bool dropOthers() {
    WaysOn waysOn = allWaysOn();
    const auto isOther = [&](std::uint32_t region) {
      const Ways& ways = waysOn[region];
      const bool isClosed = ways.areNarrow && !regions_.isNarrow(region);
      return !leadOnTwoSides(isClosed ? ways.besidesDoors : ways.directions);
    };
    const auto others = std::stable_partition(found_.begin(), found_.end(), std::not_fn(isOther));
    for (auto it = others; it != found_.end(); ++it) mayBe_[*it] = 0;
    const bool isAny = others != found_.end();
    found_.erase(others, found_.end());
    return isAny;
  }

  WaysOn allWaysOn() const {
    WaysOn waysOn;
    for (const std::uint32_t e : regions_.edges()) {
      const VoronoiEdge& edge = regions_.voronoi().edges[e];
      const std::uint32_t a = regions_.find(edge.source), b = regions_.find(edge.target);
      if (a == b || regions_.isFront(e)) continue;
      const Point across = regions_.across(edge);
      if (leadsOn(a, b, regions_.clearance(edge))) add(edge, across, waysOn[a]);
      if (leadsOn(b, a, regions_.clearance(edge))) add(edge, -1.0 * across, waysOn[b]);
    }
    return waysOn;
  }

  void add(const VoronoiEdge& edge, Point direction, Ways& ways) const {
    const std::uint32_t a = regions_.find(edge.source), b = regions_.find(edge.target);
    ways.directions.push_back(direction);
    if (!isDoorOfRoom(edge)) ways.besidesDoors.push_back(direction);
    ways.areNarrow = ways.areNarrow && isDoorOfPieces(regions_, regions_.clearance(edge), a, b);
  }

  /** In a wall, and not across a corridor. */
  bool isDoorOfRoom(const VoronoiEdge& edge) const {
    const std::vector<Point>& obstacles = regions_.voronoi().obstacles;
    return regions_.isOpeningInWall(edge, grid_, isInRoughWall) &&
           !isAcrossOneWidth(grid_, obstacles[edge.left], obstacles[edge.right]);
  }

  /** A lobby stands out: it is wider than where two corridors cross at right angles, a square. By
   *  the corridor's mean width; or by the opening, where a long stretch leads to what narrow nooks
   *  make narrower in the mean. */
  bool leadsOn(std::uint32_t region, std::uint32_t other, double clearance) const {
    const double width = regions_.meanWidth(region);
    const bool isLong = regions_.elongation(region) > kDeepestAlcove;
    return mayBe_[region] && (mayBe_[other] || kinds_[other] == RegionKind::corridor) &&
           width * (1 + kSameWidth) <
               std::sqrt(2.0) * std::max(regions_.meanWidth(other), isLong ? 2 * clearance : 0) &&
           2 * clearance >= regions_.options().narrowRatio * width * (1 - kSameWidth);
  }

  RegionGroups& regions_;
  const std::vector<RegionKind>& kinds_;
  const Grid& grid_;
  std::vector<std::uint32_t> found_;
  std::vector<std::uint8_t> mayBe_;  // per region
};

}  // namespace

void followCorridors(RegionGroups& regions, std::vector<RegionKind>& kinds, const Grid& grid) {
  for (const std::uint32_t region : Chains(regions, kinds).find())
    kinds[region] = RegionKind::corridor;
  joinPieces(regions, kinds);
  for (;;) {
    const std::vector<std::uint32_t> found = Pieces(regions, kinds, grid).find();
    if (found.empty()) return;
    for (const std::uint32_t region : found) kinds[region] = RegionKind::corridor;
    joinPieces(regions, kinds);
  }
}

}  // namespace roomgraph
