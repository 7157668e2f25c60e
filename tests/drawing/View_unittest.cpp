#include "View.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

/** Unknown but for a block of free cells of which (x, y) is the lowest on the left. */
Grid known(int side, int x, int y, int width, int height) {
  Grid grid{{side, side, 0.1, {-3, 5}}, std::vector<State>(std::size_t(side * side))};
  for (int row = y; row < y + height; ++row)
    for (int column = x; column < x + width; ++column)
      grid.cells[grid.frame.index({column, row})] = State::free;
  return grid;
}

TEST(View, showsWhatIsKnownWithAMargin) {
  const View view = viewOf(known(100, 30, 40, 20, 10));
  const int margin = 30 - view.first.x;
  EXPECT_GT(margin, 0);
  EXPECT_EQ(view.first.y, 40 - margin);
  EXPECT_EQ(view.columns, 20 + 2 * margin);
  EXPECT_EQ(view.rows, 10 + 2 * margin);
}

TEST(View, showsAllWhereNothingIsKnown) {
  const View view = viewOf(known(50, 0, 0, 0, 0));
  EXPECT_LT(view.first.x, 0);
  EXPECT_GT(view.columns, 50);
}

TEST(View, yPointsDownOnThePicture) {
  const View view = viewOf(known(100, 30, 40, 20, 10));
  const Point low = view.px(view.frame.center({30, 40})),
              high = view.px(view.frame.center({30, 45}));
  EXPECT_DOUBLE_EQ(low.x, high.x);
  EXPECT_DOUBLE_EQ(low.y - high.y, 5 * view.magnify);
  const Point corner =
      view.px(view.frame.origin + 0.1 * Point{double(view.first.x), double(view.first.y)});
  EXPECT_NEAR(corner.x, 0, 1e-9);
  EXPECT_NEAR(corner.y, view.heightPx(), 1e-9);
}

TEST(View, smallMapsAreMagnifiedAndLargeOnesReduced) {
  const View small = viewOf(known(20, 0, 0, 20, 20)), large = viewOf(known(4000, 0, 0, 4000, 4000));
  EXPECT_GT(small.magnify, 4);
  EXPECT_EQ(small.reduce, 1);
  EXPECT_EQ(large.magnify, 1);
  EXPECT_GT(large.reduce, 1);
  for (const View& view : {small, large}) {
    EXPECT_LE(view.widthPx(), 1600);
    EXPECT_EQ(view.rows % view.reduce, 0);
  }
}

}  // namespace
}  // namespace roomgraph
