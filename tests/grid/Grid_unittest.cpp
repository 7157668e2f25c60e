#include "roomgraph/grid/Grid.h"

#include <gtest/gtest.h>

#include "drawn_grid.h"

namespace roomgraph {
namespace {

TEST(Grid, CountsTheCellsBesideOneByTheirState) {
  const Grid grid = test::gridFrom({"#.",  //
                                    ".#"});
  EXPECT_EQ(grid.countBeside({0, 0}, State::occupied), 2);
  EXPECT_EQ(grid.countBeside({0, 0}, State::free), 0);
  EXPECT_EQ(grid.countBeside({0, 0}, State::unknown), 2) << "beyond the border";
  EXPECT_EQ(grid.countBeside({1, 0}, State::free), 2);
}

}  // namespace
}  // namespace roomgraph
