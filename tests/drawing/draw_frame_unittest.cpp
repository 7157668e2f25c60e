#include "draw_frame.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

TEST(DrawFrame, theScaleBarHasARoundLength) {
  EXPECT_DOUBLE_EQ(roundLength(1), 1);
  EXPECT_DOUBLE_EQ(roundLength(1.99), 1);
  EXPECT_DOUBLE_EQ(roundLength(3), 2);
  EXPECT_DOUBLE_EQ(roundLength(49), 20);
  EXPECT_DOUBLE_EQ(roundLength(0.06), 0.05);
}

TEST(DrawFrame, wordsGrowWithThePictureOnceItIsLargerThanAScreen) {
  Scene scene;
  for (const char* label : {"rooms", "corridors", "passages", "doors", "walls", "unknown"})
    scene.legend.push_back({label, [](const Pen&, Point) {}});
  const auto layout = [&](int cells) {
    View view;
    view.columns = view.rows = cells, view.frame = {cells, cells, 0.05, {}};
    return layoutOf(scene, view);
  };
  EXPECT_EQ(layout(450).map.y, layout(900).map.y);
  EXPECT_NEAR(layout(1600).map.y - 20, (layout(900).map.y - 20) * 16 / 9, 1);
  EXPECT_GT(layout(1600).legend[1].x - layout(1600).legend[0].x,
            1.7 * (layout(900).legend[1].x - layout(900).legend[0].x));
}

/** A grid whose known part is a box of cells. */
Grid gridWith(int width, int height, Cell low, Cell high) {
  Grid grid{{width, height, 0.05, {3, -4}}, {}};
  grid.cells.assign(grid.frame.cellCount(), State::unknown);
  for (int y = low.y; y <= high.y; ++y)
    for (int x = low.x; x <= high.x; ++x) grid.cells[grid.frame.index({x, y})] = State::free;
  return grid;
}

TEST(View, showsTheKnownPartWithAMargin) {
  const View view = viewOf(gridWith(1000, 1000, {300, 400}, {399, 479}));
  EXPECT_LT(view.first.x, 300);
  EXPECT_GT(view.first.x, 290);
  EXPECT_LT(view.columns, 120);
  EXPECT_GT(view.first.x + view.columns, 399);
  EXPECT_GT(view.first.y + view.rows, 479);
  EXPECT_GE(view.magnify, 4);
}

TEST(View, picturesAreBoundedForEverySize) {
  for (const int size : {1, 3, 20, 100, 350, 700, 1500, 1601, 4000, 9001}) {
    const View view = viewOf(gridWith(size, 2, {0, 0}, {size - 1, 1}));
    EXPECT_LE(view.widthPx(), 1600) << size;
    EXPECT_LE(view.heightPx(), 1600) << size;
    EXPECT_GE(view.widthPx(), 300) << size;
    EXPECT_TRUE(view.magnify == 1 || view.reduce == 1) << size;
  }
}

TEST(View, yPointsUpAndCellsMeetTheirPixels) {
  const View view = viewOf(gridWith(100, 60, {0, 0}, {99, 59}));
  const GridFrame& frame = view.frame;
  const Point low = view.px(frame.center({0, 0})), high = view.px(frame.center({0, 59}));
  EXPECT_GT(low.y, high.y);
  EXPECT_NEAR(low.y - high.y, 59 * view.magnify, 1e-9);
  EXPECT_NEAR(low.x, (-view.first.x + 0.5) * view.magnify, 1e-9);
  EXPECT_NEAR(view.heightPx() - low.y, (-view.first.y + 0.5) * view.magnify, 1e-9);
}

TEST(View, ofAnUnknownMapIsTheWholeMap) {
  Grid grid = gridWith(40, 30, {0, 0}, {0, 0});
  grid.cells.assign(grid.cells.size(), State::unknown);
  EXPECT_GE(viewOf(grid).columns, 40);
  EXPECT_GE(viewOf(grid).rows, 30);
}

}  // namespace
}  // namespace roomgraph
