#include "roomgraph/topology/kind_names.h"

#include <gtest/gtest.h>

#include <set>

namespace roomgraph {
namespace {

TEST(KindNames, everyKindHasItsOwnAndIsFoundByIt) {
  std::set<std::string> names;
  for (const VertexKind kind : {VertexKind::junction, VertexKind::deadEnd, VertexKind::border,
                                VertexKind::room, VertexKind::ring}) {
    EXPECT_TRUE(names.insert(nameOf(kind)).second) << nameOf(kind);
    EXPECT_EQ(valueOfName<VertexKind>(nameOf(kind)), kind);
  }
  EXPECT_FALSE(valueOfName<VertexKind>("door"));
  EXPECT_FALSE(valueOfName<VertexKind>(""));
}

TEST(KindNames, anEdgeWithARoomRunsInside) {
  const TopologyGraph graph({{{0, 0}, 1, VertexKind::room, RoomId(3)},
                             {{1, 0}, 1, VertexKind::border, RoomId(3)},
                             {{0, 1}, 1, VertexKind::deadEnd, RoomId(3)}},
                            {});
  Edge edge{VertexId(1), VertexId(0), {}, {}};
  EXPECT_STREQ(kindName(graph, edge), "corridor");
  edge.room = RoomId(3);
  EXPECT_STREQ(kindName(graph, edge), "room") << "from its vertex to a border";
  edge.source = VertexId(2);
  EXPECT_STREQ(kindName(graph, edge), "way");
}

}  // namespace
}  // namespace roomgraph
