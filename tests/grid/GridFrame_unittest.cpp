#include "roomgraph/grid/GridFrame.h"

#include <gtest/gtest.h>

#include <limits>

namespace roomgraph::test {
namespace {

TEST(GridFrame, knowsTheCellOfAPlace) {
  const GridFrame frame{4, 3, 0.5, {10, -1}};
  EXPECT_EQ(frame.cellAt({10.6, -0.9}).x, 1);
  EXPECT_EQ(frame.cellAt({10.6, -0.9}).y, 0);
  EXPECT_EQ(frame.center({1, 2}), (Point{10.75, 0.25}));
  EXPECT_FALSE(frame.contains(frame.cellAt({9.99, 0})));
  EXPECT_FALSE(frame.contains(frame.cellAt({1e300, 0})));
  EXPECT_FALSE(frame.contains(frame.cellAt({-1e300, 0})));
  EXPECT_FALSE(frame.contains(frame.cellAt({std::numeric_limits<double>::quiet_NaN(), 0})));
}

TEST(GridFrame, countsItsCellsRowByRowFromTheLowest) {
  const GridFrame frame{4, 3, 0.5, {10, -1}};
  EXPECT_EQ(frame.cellCount(), 12u);
  EXPECT_EQ(frame.index({0, 0}), 0u);
  EXPECT_EQ(frame.index({3, 0}), 3u);
  EXPECT_EQ(frame.index({0, 1}), 4u);
  EXPECT_TRUE(frame.contains({3, 2}));
  EXPECT_FALSE(frame.contains({4, 2}));
  EXPECT_FALSE(frame.contains({3, -1}));
}

TEST(GridFrame, theCellOfItsCentreIsTheCell) {
  const GridFrame frame{7, 5, 0.05, {-3.2, 8.75}};
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const Cell cell = frame.cellAt(frame.center({x, y}));
      EXPECT_EQ(cell.x, x);
      EXPECT_EQ(cell.y, y);
    }
}

}  // namespace
}  // namespace roomgraph::test
