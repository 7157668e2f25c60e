#include "roomgraph/breaks/find_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "drawn_building.h"
#include "drawn_graph.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

using test::bent;
using test::drawnBuilding;

/** A building, as drawn and as some motion tears it. */
struct Torn {
  Grid drawing = drawnBuilding(4, {});
  WallMap straight = wallMap(drawing);
  Point middle = drawing.frame.center({drawing.frame.width / 2, drawing.frame.height / 2});

  std::optional<PieceBreak> breakOf(const Grid& grid, const Transform2D& back) const {
    const WallMap map = wallMap(grid);
    return findPieces(map.patches, followWalls(map, straight, {{}, back}), {});
  }
};

TEST(FindPieces, aWholeMapHasNoBreak) {
  const Torn torn;
  EXPECT_FALSE(torn.breakOf(torn.drawing, {}));
  EXPECT_FALSE(findPieces({}, {}, {}));
}

TEST(FindPieces, aTurnedHalfBreaksAtTheCentreOfTheTurn) {
  const Torn torn;
  for (const double angle : {0.08, -0.12}) {
    const auto found =
        torn.breakOf(bent(torn.drawing, angle), carrying(torn.middle, torn.middle, -angle));
    ASSERT_TRUE(found) << angle;
    EXPECT_NEAR(std::abs(found->rotation), std::abs(angle), 0.01) << "the halves are alike";
    EXPECT_LT(distance(found->place, torn.middle), 1);
    EXPECT_EQ(found->shift, 0);
  }
}

TEST(FindPieces, whatIsADriftHangsOnNoOption) {
  const Torn torn;
  const double angle = 0.12;
  const WallMap map = wallMap(bent(torn.drawing, angle));
  const auto followed =
      followWalls(map, torn.straight, {{}, carrying(torn.middle, torn.middle, -angle)});
  const auto found = findPieces(map.patches, followed, {});
  FindBreaksOptions fine;
  fine.minRotation = 1e-4;
  const auto finely = findPieces(map.patches, followed, fine);
  ASSERT_TRUE(found && finely);
  EXPECT_EQ(finely->rotation, found->rotation);
}

TEST(FindPieces, aShortEndThatIsTurnedBreaksWhereItIsTorn) {
  const Torn torn;
  const Point about{6, 5};
  const auto found = torn.breakOf(test::withTornEnd(torn.drawing, about, 0.7), {});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->rotation, 0.7, 0.03);
  EXPECT_LT(distance(found->place, about), 0.5);
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
  WallPatches patches = test::patchesOver({});
  FollowedWalls followed = test::everywhere(patches, {});

  explicit Patches(const std::function<Transform2D(Point middle)>& poseAt) {
    for (FollowedPatch& f : followed.patches) f.pose = poseAt(patches[f.patch].middle);
  }
  void forget(const std::function<bool(Point middle)>& isGone) {
    auto& found = followed.patches;
    found.erase(std::remove_if(found.begin(), found.end(),
                               [&](const auto& f) { return isGone(patches[f.patch].middle); }),
                found.end());
  }
  std::optional<PieceBreak> found() const { return findPieces(patches, followed, {}); }
};

Transform2D turnedAbout(Point centre, double angle) { return carrying(centre, centre, angle); }

TEST(FindPieces, piecesMayBend) {
  for (const double angle : {0.15, -1.5, 3.0}) {
    const Patches torn([&](Point middle) {
      const Transform2D bend = turnedAbout(middle, 0.003 * (middle.x - 12));
      return middle.x > 12 ? turnedAbout({12, 0}, -angle) * bend : bend;
    });
    const auto found = torn.found();
    ASSERT_TRUE(found) << angle;
    EXPECT_NEAR(found->rotation, angle, 0.03);
    EXPECT_LT(distance(found->place, {12, 0}), 1) << angle;
    EXPECT_GT(found->bend, 0);
    EXPECT_EQ(found->pieces[0].size() + found->pieces[1].size(), torn.patches.size());
  }
}

TEST(FindPieces, aDriftIsNoBreakWhereverItIsSeen) {
  Patches drifting([](Point middle) { return turnedAbout(middle, 0.02 * middle.x); });
  EXPECT_FALSE(drifting.found());
  drifting.forget([](Point middle) { return middle.x > 8 && middle.x < 14; });
  EXPECT_FALSE(drifting.found());
}

TEST(FindPieces, theSmallerPieceIsTheOneThatIsTurned) {
  for (const bool isSmallerTurned : {false, true}) {
    const Patches torn([&](Point middle) {
      return (middle.x > 12) == isSmallerTurned ? turnedAbout({12, 0}, -0.5) : Transform2D{};
    });
    const auto found = torn.found();
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->rotation, isSmallerTurned ? 0.5 : -0.5, 1e-6);
    EXPECT_LT(distance(found->place, {12, 0}), 1e-6);
    EXPECT_GT(found->pieces[0].size(), found->pieces[1].size());
  }
}

TEST(FindPieces, whatOnlyShiftsIsWhereThePiecesComeNearest) {
  const Patches torn([](Point middle) { return Transform2D{0, middle.x > 10 ? 0.45 : 0.0, 0}; });
  const auto found = torn.found();
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->place.x, 10, 1.5);
  EXPECT_NEAR(found->shift, 0.45, 1e-6);
  EXPECT_FALSE(findPieces(torn.patches, torn.followed, {kBreakRotation, 0.5}));
}

TEST(FindPieces, manyPosesAreNoTwoPieces) {
  const Torn torn;
  FollowedWalls drifting;
  for (std::uint32_t i = 0; i < torn.straight.patches.size(); ++i)
    drifting.patches.push_back({i, {0.3 * i, 0, 0}, 10, 0});
  EXPECT_FALSE(findPieces(torn.straight.patches, drifting, {}));
}

}  // namespace
}  // namespace roomgraph
