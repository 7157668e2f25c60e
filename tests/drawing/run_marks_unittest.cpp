#include "roomgraph/drawing/run_marks.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <tuple>

namespace roomgraph {
namespace {

TEST(RunMarks, tell42RunsApart) {
  std::set<std::tuple<int, int, int, std::string>> marks;
  for (std::size_t run = 0; run < 42; ++run) {
    const Colour colour = runColour(run);
    marks.insert({colour.red, colour.green, colour.blue, runShape(run)});
  }
  EXPECT_EQ(marks.size(), 42u);
}

TEST(RunMarks, fourteenRunsHaveTheirOwnColours) {
  std::set<std::tuple<int, int, int>> colours;
  for (std::size_t run = 0; run < 14; ++run) {
    const Colour colour = runColour(run);
    colours.insert({colour.red, colour.green, colour.blue});
    EXPECT_LT(colour.red + colour.green + colour.blue, 570) << "shows on white";
  }
  EXPECT_EQ(colours.size(), 14u);
}

TEST(RunMarks, twentyEightRunsHaveTheirOwnWalls) {
  std::set<std::tuple<int, int, int, int>> walls;
  for (std::size_t run = 0; run < 28; ++run) {
    const Colour colour = runColour(run);
    walls.insert({colour.red, colour.green, colour.blue, int(runPattern(run))});
  }
  EXPECT_EQ(walls.size(), 28u);
  EXPECT_EQ(runPattern(6), RunPattern::solid);
  EXPECT_EQ(runPattern(7), RunPattern::rising);
}

}  // namespace
}  // namespace roomgraph
