#include "roomgraph/report/names.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace roomgraph {
namespace {

TEST(Names, everyKindHasItsOwnAndIsFoundByIt) {
  std::set<std::string> names;
  for (const VertexKind kind : {VertexKind::junction, VertexKind::deadEnd, VertexKind::border,
                                VertexKind::room, VertexKind::ring}) {
    EXPECT_TRUE(names.insert(kindName(kind)).second) << kindName(kind);
    EXPECT_EQ(kindOfName(kindName(kind)), kind);
  }
  EXPECT_FALSE(kindOfName("door"));
  EXPECT_FALSE(kindOfName(""));
}

TEST(Names, anEdgeWithARoomRunsInside) {
  Edge edge;
  EXPECT_STREQ(kindName(edge), "corridor");
  edge.room = RoomId(3);
  EXPECT_STREQ(kindName(edge), "room");
}

TEST(Rounded, keepsATenthOfAMillimetre) {
  EXPECT_DOUBLE_EQ(rounded(1.23456), 1.2346);
  EXPECT_EQ(rounded(rounded(1.23456)), rounded(1.23456));
  EXPECT_FALSE(std::signbit(rounded(-0.00004))) << "never -0";
  EXPECT_EQ(rounded(Point{0.00016, -2}), (Point{0.0002, -2}));
}

}  // namespace
}  // namespace roomgraph
