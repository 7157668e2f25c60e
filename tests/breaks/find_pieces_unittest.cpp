#include "roomgraph/breaks/find_pieces.h"

#include <gtest/gtest.h>

#include "drawn_building.h"

namespace roomgraph {
namespace {

using test::bent;
using test::drawnBuilding;

/** A building whose origin is in its left half, as drawn and as some motion tears it. */
struct Torn {
  Grid drawing = drawnBuilding(4, {});
  MapForAlignment straight = mapForAlignment(drawing, {});
  Point middle = drawing.frame.center({drawing.frame.width / 2, drawing.frame.height / 2});

  std::optional<PieceBreak> breakOf(const Grid& grid, const Transform2D& back) const {
    const MapForAlignment map = mapForAlignment(grid, {});
    return findPieces(map, followWalls(map, straight, {{}, back}, {}), {});
  }
};

TEST(FindPieces, aWholeMapHasNoBreak) {
  const Torn torn;
  EXPECT_FALSE(torn.breakOf(torn.drawing, {}));
  EXPECT_FALSE(findPieces({}, {}, {}));
}

TEST(FindPieces, aTurnedHalfBreaksAtTheCentreOfTheTurn) {
  const Torn torn;
  for (const double angle : {0.06, -0.12}) {
    const auto found =
        torn.breakOf(bent(torn.drawing, angle), carrying(torn.middle, torn.middle, -angle));
    ASSERT_TRUE(found) << angle;
    EXPECT_NEAR(found->rotation, angle, 0.01);
    EXPECT_LT(distance(found->place, torn.middle), 1);
    EXPECT_EQ(found->shift, 0);
    EXPECT_NEAR(found->pose.phi, 0, 0.01) << "the half at the origin is in place";
  }
}

TEST(FindPieces, aMovedHalfBreaksByItsShift) {
  const Torn torn;
  Grid moved = torn.drawing;
  const GridFrame& f = moved.frame;
  for (int y = 0; y < f.height; ++y)
    for (int x = f.width / 2; x < f.width; ++x)
      moved.cells[f.index({x, y})] = torn.drawing.atOrUnknown({x, y - 30});
  const auto found = torn.breakOf(moved, {0, -1.5, 0});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->rotation, 0, 0.01);
  EXPECT_NEAR(found->shift, 1.5, 0.1);
}

TEST(FindPieces, manyPosesAreNoTwoPieces) {
  const Torn torn;
  FollowedWalls drifting;
  for (std::uint32_t i = 0; i < torn.straight.patches.size(); ++i)
    drifting.patches.push_back({i, {0.3 * i, 0, 0}, 10, 0});
  EXPECT_FALSE(findPieces(torn.straight, drifting, {}));
}

}  // namespace
}  // namespace roomgraph
