#include "roomgraph/relate/follow_walls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/geometry/MotionFit.h"
#include "sampled_grid.h"

namespace roomgraph {
namespace {

using test::bent;
using test::drawnBuilding;

WallMap mapOf(const Grid& grid) { return wallMap(grid); }

double walls(const FollowedWalls& found) {
  double sum = 0;
  for (const FollowedPatch& patch : found.patches) sum += patch.walls;
  return sum;
}

TEST(FollowWalls, aMapLiesInAnotherOfTheSameBuildingWithoutABend) {
  const Transform2D pose{3, -2, 0.7};
  const WallMap a = mapOf(drawnBuilding(4, {})), b = mapOf(drawnBuilding(4, pose));
  const FollowedWalls found = followWalls(a, b, {pose});
  EXPECT_GT(found.share, 0.95);
  EXPECT_LT(found.bend, 0.03);
  EXPECT_NEAR(found.pose.phi, pose.phi, 0.003);
  EXPECT_LT(distance(found.pose(a.middle()), pose(a.middle())), 0.05);
}

TEST(FollowWalls, noWallIsFoundTwice) {
  const WallMap a = mapOf(bent(drawnBuilding(4, {}), 0.1)), b = mapOf(drawnBuilding(4, {}));
  const FollowedWalls found = followWalls(a, b, {{}});
  EXPECT_LE(walls(found), double(a.walls.size()));
  EXPECT_NEAR(found.share, walls(found) / double(a.walls.size()), 1e-12);
}

/** Of a building whose walls right of its middle are moved, how far the walls lie from where they
 *  belong after the best fit, by its drawing. */
double trueBend(const WallMap& straight, Point middle, const Transform2D& motion) {
  const auto drawn = [&](Point p) { return p.x > middle.x ? motion(p) : p; };
  MotionFit fit;
  for (const WallPoint& wall : straight.walls) fit.add(wall.place, drawn(wall.place));
  const Transform2D best = fit.motion();
  double squares = 0;
  for (const WallPoint& wall : straight.walls)
    squares += squaredNorm(best(wall.place) - drawn(wall.place));
  return std::sqrt(squares / fit.weight());
}

Point middleOf(const Grid& grid) {
  return grid.frame.center({grid.frame.width / 2, grid.frame.height / 2});
}

TEST(FollowWalls, theBendOfAHalfTurnedMapIsThatOfItsDrawing) {
  const Grid drawing = drawnBuilding(4, {});
  const WallMap straight = mapOf(drawing);
  const Point middle = middleOf(drawing);
  for (const double angle : {0.04, 0.08, 0.15}) {
    const double bend = followWalls(mapOf(bent(drawing, angle)), straight, {{}}).bend;
    const double truth = trueBend(straight, middle, carrying(middle, middle, angle));
    EXPECT_NEAR(bend, truth, 0.2 * truth + 0.02) << angle;
  }
}

/** The map with its right half moved up. */
Grid torn(const Grid& grid, int cells) {
  return test::redrawn(grid, [&](Cell c) {
    return c.x < grid.frame.width / 2 ? grid.at(c) : grid.atOrUnknown({c.x, c.y - cells});
  });
}

TEST(FollowWalls, aPieceThatIsFarOffIsFoundByTheOtherPoses) {
  const Grid drawing = drawnBuilding(4, {});
  const WallMap straight = mapOf(drawing), broken = mapOf(torn(drawing, 40));
  const double truth = trueBend(straight, middleOf(drawing), {0, 2, 0});
  const FollowedWalls found = followWalls(broken, straight, {{}, {0, -2, 0}});
  EXPECT_GT(found.share, 0.8);
  EXPECT_NEAR(found.bend, truth, 0.1 * truth);
  double moved = 0;
  for (const FollowedPatch& patch : found.patches)
    if (distance(patch.pose.shift(), {0, -2}) < 0.2) moved += patch.walls;
  EXPECT_GT(moved, 0.2 * double(broken.walls.size())) << "of the half that lies 2 m away";
}

/** The map with a second copy of itself to its right. */
Grid twice(const Grid& grid) {
  Grid wide = grid;
  wide.frame.width *= 2;
  return test::redrawn(wide, [&](Cell c) { return grid.at({c.x % grid.frame.width, c.y}); });
}

TEST(FollowWalls, whatTheOtherHasNotSeenIsNoPieceOfItWhereItLooksAlike) {
  const Grid drawing = drawnBuilding(4, {});
  const double width = drawing.frame.width * drawing.frame.resolution;
  WallMap both = mapOf(twice(drawing)), one = mapOf(drawing);
  const auto found = [&] { return followWalls(both, one, {{}, {-width, 0, 0}}); };
  EXPECT_LT(found().bend, 0.03);
  EXPECT_NEAR(found().share, 0.5, 0.05);
  both.hasScans = true;
  EXPECT_NEAR(found().share, 0.5, 0.05) << "the other map has none";
  one.hasScans = true;
  EXPECT_GT(found().share, 0.9) << "a torn run has come back";
}

/** The turns by which walls were found torn off, and how many of them. */
std::vector<std::pair<double, double>> tornOff(const FollowedWalls& found) {
  std::vector<std::pair<double, double>> torn;
  for (const FollowedPatch& patch : found.patches)
    if (patch.layer == kTornLayer) torn.emplace_back(patch.pose.phi, patch.walls);
  return torn;
}

TEST(FollowWalls, aShortEndThatIsTurnedIsFoundWhereItBelongs) {
  const Grid drawing = drawnBuilding(4, {});
  for (const double turn : {0.7, -1.9}) {
    WallMap whole = mapOf(drawing), torn = mapOf(test::withTornEnd(drawing, {6, 5}, turn));
    const FollowedWalls found = followWalls(torn, whole, {{}});
    double walls = 0;
    for (const auto& [phi, count] : tornOff(found)) {
      EXPECT_NEAR(wrappedAngle(phi + turn), 0, 0.03);
      walls += count;
    }
    EXPECT_GT(walls, 60) << turn;
    EXPECT_GT(found.bend, 0.1);
    whole.hasScans = torn.hasScans = true;
    EXPECT_TRUE(tornOff(followWalls(torn, whole, {{}})).empty()) << "scans tell it better";
  }
}

/** The map with boxes of a metre in rows, as desks stand. */
Grid withDesks(Grid grid, Point first, Point step) {
  for (int k = 0; k < 4; ++k)
    for (double x = -0.5; x < 0.5; x += grid.frame.resolution)
      for (double y = -0.3; y < 0.3; y += grid.frame.resolution) {
        const Point at = first + double(k) * step + Point{x, y};
        if (grid.isFree(at)) grid.cells[grid.frame.index(grid.frame.cellAt(at))] = State::occupied;
      }
  return grid;
}

TEST(FollowWalls, furnitureThatIsNewIsNotTornOff) {
  const Grid drawing = drawnBuilding(4, {});
  const WallMap desks = mapOf(withDesks(drawing, {4, 8}, {3, 0}));
  EXPECT_GT(desks.walls.size(), mapOf(drawing).walls.size() + 60);
  EXPECT_TRUE(tornOff(followWalls(desks, mapOf(drawing), {{}})).empty());
}

/** A class-room with so many rows of desks, 1.2 m apart. */
WallMap classRoom(int rows) {
  return mapOf(test::sampledGrid({240, 360, 0.05, {}}, [&](Point p) {
    if (p.x < 0.5 || p.y < 0.5 || p.x > 11.5 || p.y > 17.5) return State::occupied;
    const int row = int(std::floor((p.y - 1.5) / 1.2));
    const bool isRow = p.y - 1.5 - 1.2 * row < 0.5 && row >= 0 && row < rows;
    const bool isDesk = (p.x > 1.2 && p.x < 2.2) || (p.x > 3.1 && p.x < 4.5) ||
                        (p.x > 6.4 && p.x < 7.4) || (p.x > 9 && p.x < 10.6);
    return isRow && isDesk ? State::occupied : State::free;
  }));
}

TEST(FollowWalls, desksThatTheOtherMapHasNotAreNotThoseTwoRowsFurtherOn) {
  const FollowedWalls found = followWalls(classRoom(11), classRoom(9), {{}});
  EXPECT_TRUE(tornOff(found).empty());
  EXPECT_LT(found.bend, 0.05);
}

TEST(FollowWalls, theMisfitIsThatOfAllWallsWhetherFollowedOrNot) {
  const WallMap map = mapOf(drawnBuilding(4, {}));
  const WallMap turned = mapOf(bent(drawnBuilding(4, {}), 0.3));
  EXPECT_LT(followWalls(map, map, {{}}).misfit, 0.05);
  const FollowedWalls found = followWalls(turned, map, {{}});
  EXPECT_GT(found.misfit, 0.2);
  EXPECT_LE(found.misfit, 1);
}

TEST(FollowWalls, withoutAPoseOrWallsNothingIsFound) {
  const WallMap map = mapOf(drawnBuilding(4, {}));
  EXPECT_TRUE(followWalls(map, map, {}).patches.empty());
  EXPECT_TRUE(followWalls({}, map, {{}}).patches.empty());
  EXPECT_EQ(followWalls(map, WallMap(), {{}}).share, 0);
}

TEST(FollowWalls, theFramesOfBothMapsChangeLittle) {
  const Transform2D ofA{5, 1, -0.8}, ofB{-7, 20, 2.2};
  const Grid half = bent(drawnBuilding(4, {}), 0.08);
  const WallMap a = mapOf(half), b = mapOf(drawnBuilding(4, {}));
  const FollowedWalls here = followWalls(a, b, {{}});
  const FollowedWalls there = followWalls(a, mapOf(drawnBuilding(4, ofB)), {ofB});
  EXPECT_NEAR(there.bend, here.bend, 0.2 * here.bend);
  EXPECT_NEAR(there.share, here.share, 0.05);
  const FollowedWalls sound = followWalls(mapOf(drawnBuilding(4, ofA)),
                                          mapOf(drawnBuilding(4, ofB)), {ofB * ofA.inverse()});
  EXPECT_LT(sound.bend, 0.04);
  EXPECT_GT(sound.share, 0.9);
}

TEST(FollowWalls, aMapInItselfHardlyBends) {
  const WallMap map = mapOf(drawnBuilding(4, {}));
  const FollowedWalls found = followWalls(map, map, {{}});
  EXPECT_LT(found.bend, 0.005);
  EXPECT_GT(found.share, 0.99);
  for (const FollowedPatch& patch : found.patches) {
    EXPECT_EQ(patch.layer, 0);
    EXPECT_LT(
        distance(patch.pose(map.patches[patch.patch].middle), map.patches[patch.patch].middle),
        0.03);
  }
}

TEST(FollowWalls, theWholePoseLeavesTheLeastOver) {
  const WallMap a = mapOf(bent(drawnBuilding(4, {}), 0.1)), b = mapOf(drawnBuilding(4, {}));
  const FollowedWalls found = followWalls(a, b, {{}});
  const auto restAt = [&](const Transform2D& pose) {
    double squares = 0, count = 0;
    for (const FollowedPatch& patch : found.patches) {
      const Point middle = a.patches[patch.patch].middle;
      squares += patch.walls * squaredNorm(pose(middle) - patch.pose(middle)), count += patch.walls;
    }
    return std::sqrt(squares / count);
  };
  const double rest = restAt(found.pose);
  EXPECT_NEAR(rest, found.bend, 0.15 * found.bend) << "by the middles of the patches";
  for (const Transform2D& nudge : {Transform2D{0.1, 0, 0}, Transform2D{0, -0.1, 0},
                                   Transform2D{0, 0, 0.02}, Transform2D{0.1, 0.1, -0.02}})
    EXPECT_GT(restAt(nudge * found.pose), rest);
}

TEST(FollowWalls, whatOneHasNotSeenIsNotFound) {
  const WallMap all = mapOf(drawnBuilding(4, {}));
  const WallMap half = mapOf(drawnBuilding(4, {}, {-1e9, 12}));
  const FollowedWalls found = followWalls(all, half, {{}});
  EXPECT_LT(found.share, 0.65);
  EXPECT_GT(found.share, 0.3);
  EXPECT_LT(found.bend, 0.05);
  for (const FollowedPatch& patch : found.patches) EXPECT_LT(all.patches[patch.patch].middle.x, 14);
  EXPECT_GT(followWalls(half, all, {{}}).share, 0.9) << "and the other way round all of it is";
}

TEST(FollowWalls, theSameInputGivesTheSamePatches) {
  const WallMap a = mapOf(bent(drawnBuilding(4, {}), 0.1)), b = mapOf(drawnBuilding(4, {}));
  const FollowedWalls l = followWalls(a, b, {{}, {1, 0, 0.1}});
  const FollowedWalls r = followWalls(a, b, {{}, {1, 0, 0.1}});
  ASSERT_EQ(l.patches.size(), r.patches.size());
  EXPECT_EQ(l.bend, r.bend);
  for (std::size_t k = 0; k < l.patches.size(); ++k) {
    EXPECT_EQ(l.patches[k].patch, r.patches[k].patch);
    EXPECT_EQ(l.patches[k].pose.x, r.patches[k].pose.x);
  }
}

}  // namespace
}  // namespace roomgraph
