#include "roomgraph/rooms/split_at_doors.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "plan.h"
#include "random_maps.h"

namespace roomgraph::test {
namespace {

Regions split(const Inside& inside, const SplitAtDoorsOptions& options = {}) {
  const std::vector<std::uint8_t> allWalls(inside.voronoi.obstacles.size(), 1);
  return splitAtDoors(inside.voronoi, inside.isInside, allWalls,
                      0.75 * inside.grid.frame.resolution, inside.grid, options);
}

TEST(SplitAtDoors, aDoorPartsTwoRooms) {
  const Regions regions = split(Plan(41, 20).wall(21, 1, 1, 20).gap(21, 8, 1, 5).inside());
  EXPECT_EQ(regions.roomCount, 2u);
  EXPECT_EQ(regions.count, 2u);
}

/** A corridor of 1.2 m; on it a room of 2.2 m behind a door of 1 m, and two rooms beside that. */
Plan doorOnCorridor() {
  Plan plan(60, 19);
  plan.wall(1, 7, 60, 1);
  for (const int x : {21, 33}) plan.wall(x, 8, 1, 12);
  return plan.gap(25, 7, 5, 1);
}

TEST(SplitAtDoors, aDoorInAWallMayBeNearlyAsWideAsItsCorridor) {
  EXPECT_EQ(split(doorOnCorridor().inside()).count, 4u);
}

TEST(SplitAtDoors, aClosetMayBeAsWideAsItsDoor) {
  // 0.8 m wide and 1.2 m deep, off a corridor of 1.6 m; its opening lies in a wall, or between
  // blocks as deep as itself.
  Plan inWall(60, 15), betweenBlocks = inWall;
  inWall.wall(1, 9, 60, 1).gap(18, 9, 4, 1).wall(17, 10, 1, 6).wall(22, 10, 1, 6);
  betweenBlocks.wall(1, 9, 17, 7).wall(22, 9, 39, 7);
  const Regions closet = split(inWall.inside()), alcove = split(betweenBlocks.inside());
  EXPECT_EQ(closet.count, 4u) << "the corridor, the closet, and the spaces beside it";
  EXPECT_EQ(alcove.count, 1u);
}

TEST(SplitAtDoors, aWideOpeningDoesNot) {
  const Regions regions = split(Plan(41, 20).wall(21, 1, 1, 20).gap(21, 3, 1, 16).inside());
  EXPECT_EQ(regions.roomCount, 1u);
  EXPECT_EQ(regions.count, 1u);
}

/** A hall of 12 m, and a way out of its right side: 4 m wide, and so many cells of 0.2 m deep. */
Inside hallWithABay(int depth) {
  return Plan(60 + depth, 60).wall(61, 1, depth, 20).wall(61, 41, depth, 20).inside();
}

TEST(SplitAtDoors, aBayBelongsToItsHall) {
  EXPECT_EQ(split(hallWithABay(14)).count, 1u);
  EXPECT_EQ(split(hallWithABay(70)).count, 2u);
}

TEST(SplitAtDoors, aClosetIsARoomHoweverWideTheHallBesideIt) {
  // 1.4 m x 1.6 m behind a door of 0.8 m, beside 12 m or 3 m.
  for (const int size : {60, 15}) {
    const Plan plan = Plan(size + 9, size)
                          .wall(size + 1, 1, 9, size)
                          .gap(size + 1, 5, 1, 4)
                          .gap(size + 2, 4, 8, 7);
    EXPECT_EQ(split(plan.inside()).roomCount, 2u);
  }
}

TEST(SplitAtDoors, aDoorFrameIsNoAreaOfItsOwn) {
  // The larger room takes it.
  const Regions regions = split(Plan(45, 20).wall(20, 1, 4, 20).gap(20, 8, 4, 5).inside());
  EXPECT_EQ(regions.roomCount, 2u);
  EXPECT_EQ(regions.count, 2u);
}

TEST(SplitAtDoors, aLongWayWithTwoEndsIsACorridor) {
  const Regions regions = split(Plan(100, 30)
                                    .wall(1, 12, 100, 1)
                                    .wall(1, 22, 100, 12 - 3)
                                    .gap(10, 12, 5, 1)
                                    .gap(80, 12, 5, 1)
                                    .wall(50, 1, 1, 11)
                                    .inside());
  EXPECT_EQ(regions.roomCount, 2u);
  EXPECT_EQ(regions.count, 3u);
}

TEST(SplitAtDoors, aNarrowingDoesNotPartACorridor) {
  const Inside inside = Plan(100, 8).wall(50, 1, 1, 1).wall(50, 8, 1, 1).inside();
  EXPECT_EQ(split(inside).count, 1u);
  SplitAtDoorsOptions strict;
  strict.maxRatio = strict.corridorRatio = 1;
  EXPECT_GT(split(inside, strict).count, 1u);
}

TEST(SplitAtDoors, aShortWayBetweenTwoHallsIsNoRoom) {
  // Halls of 6 m, and 4 m of a way between them that is 2.4 or 3.2 m wide.
  const auto halls = [](int wide) {
    return Plan(80, 30).wall(31, 1, 20, 30).gap(31, 10, 20, wide).inside();
  };
  const Regions regions = split(halls(12));
  EXPECT_EQ(regions.count, 3u);
  EXPECT_EQ(regions.roomCount, 2u);
  SplitAtDoorsOptions options;
  options.maxWidth = 2.2;
  EXPECT_EQ(split(halls(12), options).roomCount, 3u);
}

TEST(SplitAtDoors, widthsDoNotDependOnTheResolution) {
  // 1.6 m are free on both: a room from there on.
  SplitAtDoorsOptions options;
  options.minRoomWidth = 1.6;
  const std::vector<std::string> coarse(8 + 2, "#" + std::string(8, '.') + "#");
  const std::vector<std::string> fine(16 + 2, "#" + std::string(16, '.') + "#");
  for (auto [rows, resolution] : {std::pair{coarse, 0.2}, {fine, 0.1}}) {
    rows.front() = rows.back() = std::string(rows[0].size(), '#');
    const Inside inside = insideOf(drawn(rows, resolution));
    options.minRoomWidth = 1.6;
    EXPECT_EQ(split(inside, options).roomCount, 1u) << resolution;
    options.minRoomWidth = 1.65;  // walls are rows of points, between which a disc reaches a bit
    EXPECT_EQ(split(inside, options).roomCount, 0u) << resolution;
  }
}

/** Cells of 0.1 m here: a bathroom of 1.5 m and a hall. */
TEST(SplitAtDoors, aNarrowRoomIsOneIfDoorsCloseIt) {
  const auto plan = [](int door) {
    std::vector<std::string> rows(42, std::string(62, '#'));
    const auto open = [&](int x, int y, int width, int height) {
      for (int row = y; row < y + height; ++row)
        for (int column = x; column < x + width; ++column)
          rows[std::size_t(row)][std::size_t(column)] = '.';
    };
    open(1, 1, 15, 20);
    open(1, 26, 60, 12);
    open(4, 21, door, 5);
    open(25, 1, 30, 20);
    open(35, 21, 8, 5);
    return insideOf(drawn(rows, 0.1));
  };
  EXPECT_EQ(split(plan(7)).roomCount, 2u);
  SplitAtDoorsOptions wide;
  wide.minRoomWidth = wide.openRoomWidth;
  EXPECT_EQ(split(plan(7), wide).roomCount, 1u);
}

TEST(SplitAtDoors, whatTheUnknownBoundsIsHalfSeen) {
  const Inside inside = Plan(41, 20).wall(21, 1, 1, 20).gap(21, 8, 1, 5).inside();
  std::vector<std::uint8_t> isWall(inside.voronoi.obstacles.size(), 1);
  for (std::size_t obstacle = 0; obstacle < isWall.size(); ++obstacle)
    isWall[obstacle] = inside.voronoi.obstacles[obstacle].x < 22 * 0.2;
  const Regions regions = splitAtDoors(inside.voronoi, inside.isInside, isWall, 0.15, inside.grid,
                                       SplitAtDoorsOptions());
  EXPECT_EQ(regions.roomCount, 1u);
  EXPECT_EQ(regions.seenCount, 1u);
  EXPECT_EQ(regions.count, 2u);
  ASSERT_EQ(regions.seen.size(), 2u);
  EXPECT_NEAR(regions.seen[0], 1, 0.05);
  EXPECT_LT(regions.seen[1], 0.4) << "but the wall with the door";
}

/** Which vertices are together, and whether in a room, whatever the regions' numbers. */
std::map<std::uint32_t, std::pair<std::uint32_t, bool>> partition(const Regions& regions) {
  std::map<std::uint32_t, std::uint32_t> firstOf;
  std::map<std::uint32_t, std::pair<std::uint32_t, bool>> result;
  for (std::uint32_t v = 0; v < regions.regionOf.size(); ++v) {
    const std::uint32_t region = regions.of(v);
    if (region == Regions::kNone) continue;
    result[v] = {firstOf.emplace(region, v).first->second, region < regions.roomCount};
  }
  return result;
}

TEST(SplitAtDoors, theOrderOfTheEdgesDoesNotMatter) {
  std::mt19937 random(3);
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    Inside inside = insideOf(noisyOffice(seed, 300));
    const auto expected = partition(split(inside));
    ASSERT_GT(expected.size(), 100u);
    auto& edges = inside.voronoi.edges;
    for (std::size_t i = edges.size(); i > 1; --i) std::swap(edges[i - 1], edges[random() % i]);
    EXPECT_EQ(partition(split(inside)), expected) << seed;
  }
}

TEST(SplitAtDoors, nothingInsideGivesNoRegion) {
  const Inside inside = insideOf(drawn({"###", "###", "###"}, 0.2));
  EXPECT_EQ(split(inside).count, 0u);
}

}  // namespace
}  // namespace roomgraph::test
