#include "roomgraph/grid/clear_wall_rims.h"

#include <gtest/gtest.h>

#include "drawn_grid.h"

namespace roomgraph {
namespace {

TEST(ClearWallRims, aRimOfOneOrTwoCellsBecomesFree) {
  const auto cleared =
      clearWallRims(test::gridFrom({"########", "#??????#", "#?....?#", "#??..??#",  //
                                    "#??????#", "########"}));
  ASSERT_TRUE(cleared);
  EXPECT_EQ(cleared->cells, test::gridFrom({"########", "#?....?#", "#......#", "#......#",  //
                                            "#?....?#", "########"})
                                .cells);
}

TEST(ClearWallRims, mapsWithWallsBesideFreeCellsStayAsTheyAre) {
  EXPECT_FALSE(clearWallRims(test::gridFrom({"######", "#...?#", "#....#", "######"})));
  EXPECT_FALSE(clearWallRims(test::gridFrom({"????", "?..?", "????"})));
  EXPECT_FALSE(clearWallRims(test::gridFrom({"...", "..."})));
}

TEST(ClearWallRims, widerGapsAndViewsIntoTheUnknownStay) {
  const auto cleared = clearWallRims(test::gridFrom({"#???..?#", "#???..?#", "????????"}));
  ASSERT_TRUE(cleared);
  EXPECT_EQ(cleared->cells, test::gridFrom({"#???...#", "#???...#", "????????"}).cells);
}

}  // namespace
}  // namespace roomgraph
