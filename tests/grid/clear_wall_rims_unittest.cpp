#include "roomgraph/grid/clear_wall_rims.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

/** Rows from the lowest: '.' free, '#' occupied, ' ' unknown. */
Grid drawn(const std::vector<std::string>& rows) {
  Grid grid;
  grid.frame.width = int(rows.front().size()), grid.frame.height = int(rows.size());
  grid.frame.resolution = 0.05;
  for (const std::string& row : rows)
    for (const char c : row)
      grid.cells.push_back(c == '.' ? State::free : c == '#' ? State::occupied : State::unknown);
  return grid;
}

TEST(ClearWallRims, aRimOfOneOrTwoCellsBecomesFree) {
  const auto cleared = clearWallRims(drawn({"########", "#      #", "# .... #", "#  ..  #",  //
                                            "#      #", "########"}));
  ASSERT_TRUE(cleared);
  EXPECT_EQ(cleared->cells, drawn({"########", "# .... #", "#......#", "#......#",  //
                                   "# .... #", "########"})
                                .cells);
}

TEST(ClearWallRims, mapsWithWallsBesideFreeCellsStayAsTheyAre) {
  EXPECT_FALSE(clearWallRims(drawn({"######", "#... #", "#....#", "######"})));
  EXPECT_FALSE(clearWallRims(drawn({"    ", " .. ", "    "})));
  EXPECT_FALSE(clearWallRims(drawn({"...", "..."})));
}

TEST(ClearWallRims, widerGapsAndViewsIntoTheUnknownStay) {
  const auto cleared = clearWallRims(drawn({"#   .. #", "#   .. #", "        "}));
  ASSERT_TRUE(cleared);
  EXPECT_EQ(cleared->cells, drawn({"#   ...#", "#   ...#", "        "}).cells);
}

}  // namespace
}  // namespace roomgraph
