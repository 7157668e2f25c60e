#include "roomgraph/rooms/split_at_doors.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

#include "RegionGroups.h"
#include "find_fronts.h"
#include "find_halls.h"
#include "follow_corridors.h"
#include "join_leftovers.h"
#include "number_regions.h"
#include "region_kinds.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

using Neighbours = RegionGroups::Neighbours;

/** Joins regions through open passages of one width. The order of these does not matter: first,
 *  regions as wide as each other join; then, in rounds, each joins the widest of the others that it
 *  is open to. So a door frame goes to one of its rooms, and not to both. */
class PassageJoiner {
 public:
  PassageJoiner(RegionGroups& regions, const Grid& grid) : regions_(regions), grid_(grid) {}

  void join(const std::uint32_t* first, const std::uint32_t* last) {
    edges_.assign(first, last);
    do findOpenPairs();
    while (joinEqual() || joinWidest());
  }

 private:
  /** Two regions that meet without a door; the narrower one first. */
  struct Pair {
    std::uint32_t region, host;
    double hostRadius;
  };

  void findOpenPairs() {
    pairs_.clear();
    const auto isJoined = [&](std::uint32_t e) {
      const VoronoiEdge& edge = regions_.voronoi().edges[e];
      std::uint32_t a = regions_.find(edge.source), b = regions_.find(edge.target);
      if (a == b) return true;
      if (regions_.radius(b) < regions_.radius(a)) std::swap(a, b);
      clearance_ = regions_.clearance(edge);
      // By the passage, not by the narrower region: that may have grown to here from the far side.
      const double least = regions_.options().narrowRatio * regions_.radius(b) * (1 - kSameWidth);
      if (clearance_ >= least && !regions_.isFront(e) && !isDoorBetween(a, b) &&
          !isDoorInWall(edge, a, b))
        pairs_.push_back({a, b, regions_.radius(b)});
      return false;
    };
    eraseIf(edges_, isJoined);
  }

  bool isDoorBetween(std::uint32_t a, std::uint32_t b) const {
    return isDoor(regions_, clearance_, a, b, regions_.options().maxRatio,
                  regions_.options().maxWidth);
  }

  /** One that is hardly narrower than the narrower of its rooms, or that leads off a corridor. */
  bool isDoorInWall(const VoronoiEdge& edge, std::uint32_t a, std::uint32_t b) const {
    const double narrower = clearance_ + regions_.halfCell() / 2;
    return isDoor(regions_, narrower, a, b, 1, regions_.options().corridorDoor)
               ? regions_.isOpeningInWall(edge, grid_)
               : regions_.isOpeningOffCorridor(edge, grid_);
  }

  bool joinEqual() {
    for (const Pair& pair : pairs_)
      if (regions_.radius(pair.region) >= pair.hostRadius * (1 - kSameWidth))
        chosen_.push_back(pair);
    return joinChosen();
  }

  bool joinWidest() {
    std::sort(pairs_.begin(), pairs_.end(), [](const Pair& p, const Pair& q) {
      return std::tie(p.region, q.hostRadius, p.host) < std::tie(q.region, p.hostRadius, q.host);
    });
    for (std::size_t i = 0, end = 0; i < pairs_.size(); i = end) {
      while (end < pairs_.size() && pairs_[end].region == pairs_[i].region) ++end;
      std::size_t tied = i;
      while (tied < end && pairs_[tied].hostRadius >= pairs_[i].hostRadius * (1 - kSameWidth))
        ++tied;
      // What lies in a door between two equal rooms stays a leftover.
      const bool isOneHost = pairs_[i].host == pairs_[tied - 1].host;
      if (isOneHost || !isDoorBetween(pairs_[i].host, pairs_[tied - 1].host))
        chosen_.insert(chosen_.end(), pairs_.begin() + std::ptrdiff_t(i),
                       pairs_.begin() + std::ptrdiff_t(tied));
    }
    return joinChosen();
  }

  bool joinChosen() {
    for (const Pair& pair : chosen_) regions_.join(pair.region, pair.host);
    const bool isAny = !chosen_.empty();
    chosen_.clear();
    return isAny;
  }

  RegionGroups& regions_;
  const Grid& grid_;
  std::vector<std::uint32_t> edges_;  // between regions that have not met yet
  double clearance_ = 0;              // of all these passages
  std::vector<Pair> pairs_, chosen_;  // members, as most widths have but one edge
};

/** From wide to narrow: what is no door joins. */
void joinOpenPassages(RegionGroups& regions, const Grid& grid) {
  const std::vector<std::uint32_t>& edges = regions.edges();
  const auto width = [&](std::size_t i) { return regions.voronoi().edges[edges[i]].minClearance; };
  PassageJoiner joiner(regions, grid);
  for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
    while (end < edges.size() && width(end) >= width(first) * (1 - kSameWidth)) ++end;
    joiner.join(edges.data() + first, edges.data() + end);
  }
}

std::vector<double> seenShares(RegionGroups& regions, const Regions& found) {
  std::vector<double> seen(found.count);
  regions.eachRegion([&](std::uint32_t region) {
    seen[found.regionOf[region]] = std::min(1.0, regions.wallShare(region));
  });
  return seen;
}

}  // namespace

void describe(SplitAtDoorsOptions& options, FieldTable& table) {
  const char* section = "split_at_doors";
  table.number(
      section, "max_ratio", options.maxRatio, "", 0, 1,
      "A passage is a door where it is narrower than this share of the narrower of its two "
      "sides.");
  table.number(section, "max_width", options.maxWidth, "m", 0, 100,
               "A passage wider than this is not a door; a region wider than this is not a short "
               "stretch of corridor.");
  table.number(
      section, "narrow_ratio", options.narrowRatio, "", 0, 1,
      "Two regions are kept apart where the passage between them is narrower than this share of "
      "the wider one, even without a door.");
  table.number(section, "max_leftover_area", options.maxLeftoverArea, "m2", 0, 1e6,
               "A region with less area is a leftover and joins a neighbour.");
  table.number(section, "min_elongation", options.minElongation, "", 0, 1e6,
               "A region whose area is less than this many squares round its largest disc is a "
               "leftover.");
  table.number(section, "min_room_width", options.minRoomWidth, "m", 0, 100,
               "A region in which no disc of this diameter fits is no room.");
  table.number(section, "open_room_width", options.openRoomWidth, "m", 0, 100,
               "A narrower region is a room only if all ways out of it are doors.");
  table.number(section, "min_wall_share", options.minWallShare, "", 0, 1,
               "A region with less wall round it than this share of what the map's areas have is "
               "half seen: no room and no corridor.");
  table.number(section, "min_closed_share", options.minClosedShare, "", 0, 1,
               "The same as min_wall_share, for a room narrower than open_room_width.");
  table.number(section, "max_elongation", options.maxElongation, "", 1, 1e6,
               "A region whose area is more than this many squares round its largest disc is a "
               "corridor.");
  table.number(section, "max_corridor_width", options.maxCorridorWidth, "m", 0, 1000,
               "A region wider than this is a room, however long it is.");
  table.number(section, "corridor_ratio", options.corridorRatio, "", 0, 1,
               "The same as max_ratio between two pieces of corridor.");
  table.number(section, "corridor_door", options.corridorDoor, "m", 0, 100,
               "The same as max_width between two pieces of corridor, and in a wall that goes on.");
}

Regions splitAtDoors(const VoronoiGraph& voronoi, const InsideFlags& isInside,
                     const std::vector<std::uint8_t>& isWall, double minClearance, const Grid& grid,
                     const SplitAtDoorsOptions& options) {
  const InsideFlags isClear = clearInside(voronoi, isInside, minClearance);
  const double halfCell = grid.frame.resolution / 2;
  RegionGroups regions(voronoi, isClear, minClearance, halfCell, options);
  regions.keepFronts(findFronts(regions, grid));
  joinOpenPassages(regions, grid);
  regions.sumAreas();
  regions.sumWalls(isWall);
  regions.findOpeningsOffCorridors(grid);
  joinLeftovers(regions);
  std::vector<RegionKind> kinds = regionKinds(regions, ownWidths(regions, isWall));
  followCorridors(regions, kinds, grid);
  joinDoorFrames(regions, kinds);
  // A joined region goes by the smallest of its parts, all of which are alike.
  const auto kindOf = [&](std::uint32_t v) { return kinds[v]; };
  const auto areaOf = [&](std::uint32_t v) { return regions.area(v); };
  const auto numbered = [&] {
    return numberRegions(voronoi, regions.groups(), isClear, kindOf, areaOf, 0);
  };
  Regions found = numbered();
  const std::vector<std::uint8_t> isHall = findHalls(voronoi, found, options);
  if (contains(isHall, 1)) {
    for (std::uint32_t v = 0; v < kinds.size(); ++v)
      if (found.regionOf[v] != Regions::kNone && isHall[found.regionOf[v]])
        kinds[v] = RegionKind::room;
    found = numbered();
  }
  found.seen = seenShares(regions, found);
  return found;
}

}  // namespace roomgraph
