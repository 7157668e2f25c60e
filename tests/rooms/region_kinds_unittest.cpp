#include "region_kinds.h"

#include <gtest/gtest.h>

#include <functional>

#include "join_leftovers.h"
#include "plan.h"

namespace roomgraph::test {
namespace {

/** A map whose space is cut at all passages of less than 1.2 m. Places are told in cells from its
 *  left upper corner. */
class Kinds {
 public:
  /** `isWall` tells the obstacles that are wall by their place; the others are unknown. */
  explicit Kinds(
      const Plan& plan, const SplitAtDoorsOptions& options = {},
      const std::function<bool(Point)>& isWall = [](Point) { return true; })
      : inside_(plan.inside()) {
    const double cell = inside_.grid.frame.resolution;
    RegionGroups regions(inside_.voronoi, inside_.isInside, 0.75 * cell, cell / 2, options);
    for (const std::uint32_t e : regions.edges()) {
      const VoronoiEdge& edge = inside_.voronoi.edges[e];
      if (regions.clearance(edge) >= 0.6) regions.join(edge.source, edge.target);
    }
    regions.sumAreas();
    std::vector<std::uint8_t> walls;
    for (const Point obstacle : inside_.voronoi.obstacles) walls.push_back(isWall(obstacle));
    regions.sumWalls(walls);
    joinLeftovers(regions);
    kinds_ = regionKinds(regions, ownWidths(regions, walls));
    for (std::uint32_t v = 0; v < kinds_.size(); ++v) kinds_[v] = kinds_[regions.find(v)];
  }

  /** What the widest place within 1 m is. */
  RegionKind at(int x, int y) const {
    const Point place = inside_.grid.frame.center({x, inside_.grid.frame.height - 1 - y});
    std::size_t widest = 0;
    double clearance = -1;
    for (std::size_t v = 0; v < kinds_.size(); ++v) {
      const VoronoiVertex& vertex = inside_.voronoi.vertices[v];
      if (!inside_.isInside[v] || distance(vertex.place, place) > 1) continue;
      if (vertex.clearance > clearance) clearance = vertex.clearance, widest = v;
    }
    EXPECT_GE(clearance, 0) << "nothing lies there";
    return kinds_[widest];
  }

 private:
  Inside inside_;
  std::vector<RegionKind> kinds_;
};

/** Two rooms of 6 m x 5 m behind doors of 0.8 m; along them runs a way as wide as told. */
Plan roomsAlong(int width) {
  return Plan(61, width + 26)
      .wall(1, width + 1, 61, 1)
      .wall(31, width + 1, 1, 26)
      .gap(14, width + 1, 4, 1)
      .gap(46, width + 1, 4, 1);
}

TEST(RegionKinds, roomsLieBehindDoorsAndTheWayAlongThemIsACorridor) {
  const Kinds kinds(roomsAlong(8));
  EXPECT_EQ(kinds.at(31, 4), RegionKind::corridor);
  EXPECT_EQ(kinds.at(16, 22), RegionKind::room);
  EXPECT_EQ(kinds.at(46, 22), RegionKind::room);
}

TEST(RegionKinds, aWideWayIsARoomHoweverLongItIs) {
  // 12 m long; the bound is lowered so that one plan serves for both.
  SplitAtDoorsOptions options;
  options.maxElongation = 2;
  options.maxCorridorWidth = 4;
  EXPECT_EQ(Kinds(roomsAlong(18), options).at(31, 9), RegionKind::corridor) << "3.6 m";
  EXPECT_EQ(Kinds(roomsAlong(22), options).at(31, 11), RegionKind::room) << "4.4 m";
}

TEST(RegionKinds, aWayIsNotWideWhereOneBayOfItIs) {
  // 30 m x 4 m with a bay that holds a disc of 6.6 m, and a room at each end.
  const auto way = [](int above) {
    return Plan(192, above + 20)
        .wall(22, 1, 58, above)
        .wall(114, 1, 58, above)
        .wall(21, 1, 1, above + 20)
        .wall(172, 1, 1, above + 20)
        .gap(21, above + 8, 1, 4)
        .gap(172, above + 8, 1, 4);
  };
  EXPECT_EQ(Kinds(way(14)).at(97, 17), RegionKind::corridor);
  EXPECT_EQ(Kinds(way(14)).at(10, 17), RegionKind::room);
}

TEST(RegionKinds, theLongSpaceBehindOneDoorIsARoom) {
  // 9 m x 2 m: with a second door it would be a corridor.
  const auto store = [] { return Plan(72, 20).wall(26, 1, 1, 20).wall(27, 11, 46, 10); };
  EXPECT_EQ(Kinds(store().gap(26, 4, 1, 4)).at(50, 6), RegionKind::room);
  const Plan through = Plan(99, 20)
                           .wall(26, 1, 1, 20)
                           .wall(27, 11, 46, 10)
                           .wall(73, 1, 1, 20)
                           .gap(26, 4, 1, 4)
                           .gap(73, 4, 1, 4);
  EXPECT_EQ(Kinds(through).at(50, 6), RegionKind::corridor);
}

TEST(RegionKinds, aBlindWingIsACorridor) {
  // 2 m wide, behind one opening of 1 m; by its length.
  const auto wing = [](int cells) {
    return Kinds(Plan(26 + cells, 20).wall(26, 1, 1, 20).wall(27, 11, cells, 10).gap(26, 4, 1, 5))
        .at(26 + cells / 2, 6);
  };
  EXPECT_EQ(wing(60), RegionKind::room) << "12 m";
  EXPECT_EQ(wing(100), RegionKind::corridor) << "20 m";
}

TEST(RegionKinds, aSpaceNarrowerThanARoomIsACorridor) {
  SplitAtDoorsOptions options;
  const auto kindOfSpace = [&] {
    return Kinds(Plan(41, 20).wall(21, 1, 1, 20).gap(21, 8, 1, 4), options).at(30, 10);
  };
  EXPECT_EQ(kindOfSpace(), RegionKind::room);
  options.minRoomWidth = 4.1;  // both are 4 m wide
  EXPECT_EQ(kindOfSpace(), RegionKind::corridor);
}

TEST(RegionKinds, whatBeamsHaveSeenOfARoomFromACorridorIsARoom) {
  // 1.4 m wide behind a door of 0.8 m; half of what bounds it is the edge of the unknown.
  const auto nook = [](int length) {
    return Plan(length, 18)
        .wall(1, 10, length, 1)
        .wall(10, 11, 1, 8)
        .wall(18, 11, 1, 8)
        .gap(12, 10, 4, 1);
  };
  const auto isSeen = [](Point p) { return p.y > 8 * 0.2 || p.x < 14 * 0.2 || p.x > 18.5 * 0.2; };
  EXPECT_EQ(Kinds(nook(90)).at(14, 14), RegionKind::room);
  EXPECT_EQ(Kinds(nook(90), {}, isSeen).at(14, 14), RegionKind::room) << "off a corridor";
  EXPECT_EQ(Kinds(nook(20), {}, isSeen).at(14, 14), RegionKind::corridor) << "of a room";
}

TEST(RegionKinds, whatHasLittleWallRoundItIsHalfSeen) {
  const Plan plan = Plan(61, 20).wall(31, 1, 1, 20).gap(31, 8, 1, 4);
  const auto isLeft = [](Point p) { return p.x < 32 * 0.2; };
  const Kinds kinds(plan, {}, isLeft);
  EXPECT_EQ(kinds.at(16, 10), RegionKind::room);
  EXPECT_EQ(kinds.at(50, 10), RegionKind::halfSeen);
}

}  // namespace
}  // namespace roomgraph::test
