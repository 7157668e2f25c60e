#include "roomgraph/topology/kind_names.h"

#include <gtest/gtest.h>

#include <set>

namespace roomgraph {
namespace {

TEST(KindNames, everyKindHasItsOwnAndIsFoundByIt) {
  std::set<std::string> names;
  for (const VertexKind kind : {VertexKind::junction, VertexKind::deadEnd, VertexKind::border,
                                VertexKind::room, VertexKind::ring}) {
    EXPECT_TRUE(names.insert(kindName(kind)).second) << kindName(kind);
    EXPECT_EQ(kindOfName(kindName(kind)), kind);
  }
  EXPECT_FALSE(kindOfName("door"));
  EXPECT_FALSE(kindOfName(""));
}

TEST(KindNames, anEdgeWithARoomRunsInside) {
  Edge edge;
  EXPECT_STREQ(kindName(edge), "corridor");
  edge.room = RoomId(3);
  EXPECT_STREQ(kindName(edge), "room");
}

}  // namespace
}  // namespace roomgraph
