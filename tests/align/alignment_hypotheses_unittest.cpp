#include "roomgraph/align/alignment_hypotheses.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_building.h"
#include "roomgraph/align/near_poses.h"

namespace roomgraph {
namespace {

const Point kMiddle{12, 8};  // of the drawn building

/** The place of the first hypothesis near the truth; the number of all where there is none. */
std::size_t rankOfTruth(const Transform2D& bFromA, const test::Seen& seen) {
  const MapForAlignment a = mapForAlignment(test::drawnBuilding(5, {}), {});
  const MapForAlignment b = mapForAlignment(test::drawnBuilding(5, bFromA, seen), {});
  const auto found = alignmentHypotheses(a, b, {});
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
  const MapForAlignment map = mapForAlignment(test::drawnBuilding(2, {}), {});
  const auto found = alignmentHypotheses(map, map, {});
  ASSERT_GT(found.size(), 10u);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end(),
                             [](const auto& l, const auto& r) { return l.score > r.score; }));
}

TEST(AlignmentHypotheses, withoutWallsThereAreNone) {
  const MapForAlignment map = mapForAlignment(test::drawnBuilding(2, {}), {});
  const MapForAlignment empty = mapForAlignment(Grid{}, {});
  EXPECT_TRUE(alignmentHypotheses(map, empty, {}).empty());
  EXPECT_TRUE(alignmentHypotheses(empty, map, {}).empty());
}

}  // namespace
}  // namespace roomgraph
