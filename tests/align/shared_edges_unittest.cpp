#include "roomgraph/align/shared_edges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "drawn_building.h"
#include "drawn_hall.h"
#include "roomgraph/align/wall_map.h"
#include "sampled_grid.h"

namespace roomgraph {
namespace {

using test::drawnBuilding;

DrawnEdges edgesOf(const Grid& grid) { return bareWallMap(grid).edges; }

const Grid& picture() {
  static const Grid grid = drawnBuilding(3, {});
  return grid;
}

/** The picture with each cell as `cellOf` says, in its frame. */
Grid edited(const std::function<State(Cell)>& cellOf) { return test::redrawn(picture(), cellOf); }

Grid quarterTurned(const Grid& grid) {
  Grid turned;
  turned.frame = grid.frame;
  std::swap(turned.frame.width, turned.frame.height);
  turned.frame.origin = {0, 0};
  turned.cells.resize(grid.cells.size());
  for (int y = 0; y < grid.frame.height; ++y)
    for (int x = 0; x < grid.frame.width; ++x)
      turned.cells[turned.frame.index({grid.frame.height - 1 - y, x})] = grid.at({x, y});
  return turned;
}

TEST(SharedEdges, areAllOfTheSamePictureWhereverItsOriginIs) {
  Grid moved = picture();
  moved.frame.origin = moved.frame.origin + Point{3.02, -7.01};
  const SharedEdges shared = sharedEdges(edgesOf(picture()), edgesOf(moved), {{-3, 7, 0.001}});
  EXPECT_EQ(shared.ofA, 1);
  EXPECT_EQ(shared.ofB, 1);
}

TEST(SharedEdges, aQuarterTurnIsFollowed) {
  const Grid turned = quarterTurned(picture());
  const GridFrame& frame = picture().frame;
  // turned <- building: (x, y) of the picture comes to (height - y, x).
  const Transform2D pose{frame.height * frame.resolution + frame.origin.y, -frame.origin.x, M_PI_2};
  EXPECT_EQ(sharedEdges(edgesOf(turned), edgesOf(picture()), {pose}).ofB, 1);
  EXPECT_TRUE(areEdits(edgesOf(turned), edgesOf(picture()), {{}, pose}));
  EXPECT_FALSE(areEdits(edgesOf(turned), edgesOf(picture()), {{}})) << "it lies elsewhere";
}

TEST(AreEdits, aCropAndAnErasedWallAreEdits) {
  const int width = picture().frame.width;
  const Grid half =
      edited([&](Cell c) { return c.x < width / 2 ? picture().at(c) : State::unknown; });
  const Grid erased = edited([&](Cell c) {
    const bool isWall = picture().at(c) == State::occupied && c.x > width / 3 && c.x < width / 2;
    return isWall ? State::free : picture().at(c);
  });
  EXPECT_TRUE(areEdits(edgesOf(picture()), edgesOf(half), {{}}));
  EXPECT_TRUE(areEdits(edgesOf(erased), edgesOf(picture()), {{}}));
}

TEST(AreEdits, theSameBuildingDrawnTwiceIsNoEdit) {
  for (const Transform2D& pose : {Transform2D{0.02, 0.03, 0.01}, Transform2D{2, 1, 0.4}}) {
    const Grid other = drawnBuilding(3, pose);
    const Transform2D back = pose.inverse();
    EXPECT_FALSE(areEdits(edgesOf(picture()), edgesOf(other), {back})) << pose.phi;
  }
}

TEST(AreEdits, aMapOfOtherCellsOrWithNextToNothingDrawnIsNone) {
  Grid coarse = picture();
  coarse.frame.resolution = 0.06;
  EXPECT_FALSE(areEdits(edgesOf(picture()), edgesOf(coarse), {{}}));
  EXPECT_FALSE(areEdits(edgesOf(picture()), edgesOf(picture()), {})) << "without a pose";
  EXPECT_FALSE(areEdits(edgesOf(Grid{}), edgesOf(picture()), {{}}));
  const Grid speck =
      edited([](Cell c) { return c.x == 50 && c.y < 60 ? State::occupied : State::free; });
  EXPECT_FALSE(areEdits(edgesOf(speck), edgesOf(speck), {{}}));
}

TEST(AreIdentical, aMapAndItsCopyAre) {
  const WallMap hall = wallMap(test::drawnHall(0.1, 0));
  EXPECT_TRUE(areIdentical(hall, wallMap(test::drawnHall(0.1, 0))));
  EXPECT_TRUE(areIdentical(wallMap(Grid{}), wallMap(Grid{})));
}

TEST(AreIdentical, aMapThatDiffersInAWallOrInItsPlaceIsNot) {
  const WallMap hall = wallMap(test::drawnHall(0.1, 0));
  EXPECT_FALSE(areIdentical(hall, wallMap(test::drawnHall(0.1, 0.4))));
  Grid moved = test::drawnHall(0.1, 0);
  moved.frame.origin.x += 0.05;
  EXPECT_FALSE(areIdentical(hall, wallMap(moved)));
}

}  // namespace
}  // namespace roomgraph
