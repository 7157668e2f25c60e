#include "roomgraph/grid/CellBox.h"

#include <gtest/gtest.h>

#include "drawn_grid.h"

namespace roomgraph {
namespace {

TEST(CellBox, HoldsWhatItHasIncluded) {
  CellBox box;
  EXPECT_TRUE(box.isEmpty());
  EXPECT_FALSE(box.contains({0, 0}));
  box.include({-2, 3});
  EXPECT_EQ(box.width(), 1);
  EXPECT_EQ(box.height(), 1);
  box.include({1, 2});
  EXPECT_EQ(box.width(), 4);
  EXPECT_EQ(box.height(), 2);
  EXPECT_TRUE(box.contains({0, 3}));
  EXPECT_FALSE(box.contains({0, 4}));
}

TEST(CellBox, IsRoundAllThatIsKnown) {
  const CellBox box = knownCells(test::gridFrom({"?????",  //
                                                 "??.??",  //
                                                 "?#???",  //
                                                 "?????"}));
  EXPECT_EQ(box.low.x, 1);
  EXPECT_EQ(box.low.y, 1);
  EXPECT_EQ(box.high.x, 2);
  EXPECT_EQ(box.high.y, 2);
  EXPECT_TRUE(knownCells(test::gridFrom({"??", "??"})).isEmpty());
  EXPECT_TRUE(knownCells({}).isEmpty());
}

}  // namespace
}  // namespace roomgraph
