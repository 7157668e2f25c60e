#include "roomgraph/breaks/MapBreak.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

BreakClass kindOf(double rotation, double shift) {
  MapBreak found;
  found.rotation = rotation, found.shift = shift;
  return found.kind();
}

TEST(MapBreak, isOfTheClassOfItsTurnOrOfItsShift) {
  EXPECT_EQ(kindOf(0.05, 0.1), BreakClass::slight);
  EXPECT_EQ(kindOf(-0.1, 0), BreakClass::clear);
  EXPECT_EQ(kindOf(0, 0.5), BreakClass::clear);
  EXPECT_EQ(kindOf(-0.3, 0), BreakClass::apart);
  EXPECT_EQ(kindOf(0, 1.3), BreakClass::apart);
  EXPECT_STREQ(nameOf(kindOf(0.05, 0.1)), "slight");
  EXPECT_STREQ(nameOf(kindOf(0, 0.5)), "clear");
  EXPECT_STREQ(nameOf(kindOf(1, 0)), "apart");
}

}  // namespace
}  // namespace roomgraph
