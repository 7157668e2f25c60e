#include "roomgraph/breaks/find_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "drawn_building.h"
#include "drawn_graph.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

using test::bent;
using test::drawnBuilding;

/** A building whose origin is in its left half, as drawn and as some motion tears it. */
struct Torn {
  Grid drawing = drawnBuilding(4, {});
  WallMap straight = wallMap(drawing);
  Point middle = drawing.frame.center({drawing.frame.width / 2, drawing.frame.height / 2});

  std::optional<PieceBreak> breakOf(const Grid& grid, const Transform2D& back) const {
    const WallMap map = wallMap(grid);
    return findPieces(map, straight, followWalls(map, straight, {{}, back}), {});
  }
};

TEST(FindPieces, aWholeMapHasNoBreak) {
  const Torn torn;
  EXPECT_FALSE(torn.breakOf(torn.drawing, {}));
  EXPECT_FALSE(findPieces({}, {}, {}, {}));
}

TEST(FindPieces, aTurnedHalfBreaksAtTheCentreOfTheTurn) {
  const Torn torn;
  for (const double angle : {0.08, -0.12}) {
    const auto found =
        torn.breakOf(bent(torn.drawing, angle), carrying(torn.middle, torn.middle, -angle));
    ASSERT_TRUE(found) << angle;
    EXPECT_NEAR(found->rotation, angle, 0.01);
    EXPECT_LT(distance(found->place, torn.middle), 1);
    EXPECT_EQ(found->shift, 0);
    EXPECT_TRUE(found->isPlaced);
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

/** Patches over 20 m, and where they are found by their middle. */
struct Patches {
  WallMap map, in;  // nothing is known of the free ground of `in`
  FollowedWalls followed;

  explicit Patches(const std::function<Transform2D(Point middle)>& poseAt) {
    map.patches = test::patchesOver({});
    followed = test::everywhere(map.patches, {});
    for (FollowedPatch& f : followed.patches) f.pose = poseAt(map.patches[f.patch].middle);
  }
  void forget(const std::function<bool(Point middle)>& isGone) {
    auto& found = followed.patches;
    found.erase(std::remove_if(found.begin(), found.end(),
                               [&](const auto& f) { return isGone(map.patches[f.patch].middle); }),
                found.end());
  }
  std::optional<PieceBreak> found() const { return findPieces(map, in, followed, {}); }
};

Transform2D turnedAbout(Point centre, double angle) { return carrying(centre, centre, angle); }

TEST(FindPieces, piecesMayBend) {
  for (const double angle : {0.15, -1.5, 3.0}) {
    const Patches torn([&](Point middle) {
      const Transform2D bend = turnedAbout(middle, 0.003 * (middle.x - 10));
      return middle.x > 10 ? turnedAbout({10, 0}, -angle) * bend : bend;
    });
    const auto found = torn.found();
    ASSERT_TRUE(found) << angle;
    EXPECT_NEAR(found->rotation, angle, 0.03);
    EXPECT_LT(distance(found->place, {10, 0}), 1) << angle;
    EXPECT_GT(found->bend, 0);
    EXPECT_NEAR(double(found->pieces[0].size()), double(found->pieces[1].size()), 10);
    EXPECT_EQ(found->pieces[0].size() + found->pieces[1].size(), torn.map.patches.size());
  }
}

TEST(FindPieces, aDriftIsNoBreakWhereverItIsSeen) {
  Patches drifting([](Point middle) { return turnedAbout(middle, 0.02 * middle.x); });
  EXPECT_FALSE(drifting.found());
  drifting.forget([](Point middle) { return middle.x > 8 && middle.x < 14; });
  EXPECT_FALSE(drifting.found());
}

TEST(FindPieces, aTurnAboutFarAwayHasNoPlace) {
  const auto found = Patches([](Point middle) {
                       return middle.x > 10 ? turnedAbout({10, 60}, -0.5) : Transform2D{};
                     }).found();
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->rotation, 0.5, 1e-6);
  EXPECT_FALSE(found->isPlaced);
}

TEST(FindPieces, theFirstPieceIsThatOfTheOrigin) {
  for (const bool isFarFirst : {false, true}) {
    const Transform2D back = turnedAbout({10, 0}, -0.5);
    const Patches torn(
        [&](Point middle) { return (middle.x > 10) != isFarFirst ? back : Transform2D{}; });
    const auto found = torn.found();
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->rotation, isFarFirst ? -0.5 : 0.5, 1e-6);
  }
}

TEST(FindPieces, theFirstPieceHasTheOriginOnFreeGround) {
  Patches torn([](Point middle) {
    return middle.x > 10 ? turnedAbout({10, 0}, -0.5) : Transform2D{};
  });
  torn.in.frame = {100, 20, 0.5, {-5, -5}};
  for (const bool isFirstFree : {true, false}) {
    std::vector<float> depths(2000, isFirstFree ? 1 : 0);
    const Point other = turnedAbout({10, 0}, -0.5)({});
    depths[cellIndexAt(torn.in.frame, other)] = isFirstFree ? 0 : 1;
    torn.in.depths = SparseCells<float>(depths, 0);
    const auto found = torn.found();
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->rotation, isFirstFree ? 0.5 : -0.5, 1e-6);
  }
}

TEST(FindPieces, manyPosesAreNoTwoPieces) {
  const Torn torn;
  FollowedWalls drifting;
  for (std::uint32_t i = 0; i < torn.straight.patches.size(); ++i)
    drifting.patches.push_back({i, {0.3 * i, 0, 0}, 10, 0});
  EXPECT_FALSE(findPieces(torn.straight, torn.straight, drifting, {}));
}

}  // namespace
}  // namespace roomgraph
