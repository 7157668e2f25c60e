#include "roomgraph/align/alignment_hypotheses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_building.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/align/wall_map.h"
#include "search_images.h"

namespace roomgraph {
namespace {

const Point kMiddle{12, 8};  // of the drawn building

/** The place of the first hypothesis near the truth; the number of all where there is none. */
std::size_t rankOfTruth(const Transform2D& bFromA, const test::Seen& seen) {
  const WallMap a = wallMap(test::drawnBuilding(5, {}));
  const WallMap b = wallMap(test::drawnBuilding(5, bFromA, seen));
  const auto found = alignmentHypotheses(a, b);
  const Point at = bFromA(kMiddle);
  const auto first = std::find_if(found.begin(), found.end(), [&](const AlignmentHypothesis& h) {
    return areNear(h.pose, bFromA.inverse(), at, {0.05, 0.4});
  });
  return std::size_t(first - found.begin());
}

TEST(AlignmentHypotheses, theTruthIsAmongTheFirst) {
  EXPECT_LT(rankOfTruth({}, {}), 3u);
  EXPECT_LT(rankOfTruth({2, 1, 0.6}, {}), 3u);
  EXPECT_LT(rankOfTruth({-30, 4, -2.5}, {}), 3u);
}

TEST(AlignmentHypotheses, halfOfTheBuildingIsEnough) {
  EXPECT_LT(rankOfTruth({2, 1, 0.6}, {-1e9, 12}), 100u);
}

TEST(AlignmentHypotheses, areOrderedByTheirScores) {
  const WallMap map = wallMap(test::drawnBuilding(2, {}));
  const auto found = alignmentHypotheses(map, map);
  ASSERT_GT(found.size(), 10u);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end(),
                             [](const auto& l, const auto& r) { return l.score > r.score; }));
}

TEST(AlignmentHypotheses, withoutWallsThereAreNone) {
  const WallMap map = wallMap(test::drawnBuilding(2, {}));
  const WallMap empty = wallMap(Grid{});
  EXPECT_TRUE(alignmentHypotheses(map, empty).empty());
  EXPECT_TRUE(alignmentHypotheses(empty, map).empty());
}

TEST(AlignmentHypotheses, aSquareHallLiesInItselfByEachQuarterTurn) {
  const WallMap hall = wallMap(test::squareHall({}));
  const auto found = alignmentHypotheses(hall, hall);
  for (const double turn : {0.0, M_PI / 2, M_PI, -M_PI / 2}) {
    const auto near = std::find_if(found.begin(), found.end(), [&](const AlignmentHypothesis& h) {
      return areNear(h.pose, {0, 0, turn}, {}, {0.05, 0.4});
    });
    ASSERT_NE(near, found.end()) << turn;
    EXPECT_LT(near - found.begin(), 6) << turn;
  }
}

TEST(AlignmentHypotheses, aScoreIsTheSumOfWhatTheWallsOfBothAreWorth) {
  SearchEffort all = kFullSearch;
  all.points = 800;
  const WallMap a = wallMap(test::drawnBuilding(5, {}));
  const WallMap b = wallMap(test::squareHall({}));
  const auto found = alignmentHypotheses(a, b, all);
  const CentredMap fixed = centred(a), moved = centred(b);
  const auto valueAt = [](const SearchImages& images, int octant, Cell cell) {
    const int x = cell.x - images.low.x, y = cell.y - images.low.y;
    if (x < 0 || y < 0 || x >= images.width || y >= images.height) return 0;
    return int(images.values[std::size_t(octant)][images.index(x, y)]);
  };
  ASSERT_GT(found.size(), 20u);
  for (std::size_t i = 0; i < 20; ++i) {
    // The angle that was tried, to the last bit: what lies on a boundary of cells hangs on it.
    const auto step = std::lround((found[i].pose.phi + 2 * M_PI) / M_PI * 90) % 180;
    const double angle = double(step) * 2 * M_PI / 180;
    const Point shift = found[i].pose(b.middle()) - a.middle();
    const Cell cell{int(std::lround(shift.x / all.cell)), int(std::lround(shift.y / all.cell))};
    int sum = 0;
    // To a sum at shift s each point gives the other's image at s less the point.
    const SearchImages images = imagesOf(fixed, 0, all.cell, 1);
    for (const SearchPoint& p : searchPoints(moved, angle, all.cell, 800, -1))
      sum += valueAt(images, p.octant, {cell.x - p.cell.x, cell.y - p.cell.y});
    const SearchImages turned = imagesOf(moved, angle, all.cell, -1);
    for (const SearchPoint& p : searchPoints(fixed, 0, all.cell, 800, 1))
      sum += valueAt(turned, p.octant, {cell.x - p.cell.x, cell.y - p.cell.y});
    EXPECT_EQ(found[i].score, sum) << i;
  }
}

TEST(AlignmentHypotheses, noneIsNearABetterOne) {
  const WallMap a = wallMap(test::drawnBuilding(5, {}));
  const WallMap b = wallMap(test::drawnBuilding(5, {2, 1, 0.6}));
  const auto found = alignmentHypotheses(a, b);
  for (std::size_t i = 0; i < std::min<std::size_t>(found.size(), 100); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(areNear(found[i].pose, found[j].pose, b.middle(), {0.08, 0.4}));
}

TEST(AlignmentHypotheses, noMoreAreKeptThanAskedFor) {
  const WallMap map = wallMap(test::drawnBuilding(2, {}));
  SearchEffort few = kFullSearch;
  few.poses = 7;
  const auto all = alignmentHypotheses(map, map), some = alignmentHypotheses(map, map, few);
  ASSERT_EQ(some.size(), 7u);
  for (std::size_t i = 0; i < some.size(); ++i) EXPECT_EQ(some[i].score, all[i].score);
}

}  // namespace
}  // namespace roomgraph
