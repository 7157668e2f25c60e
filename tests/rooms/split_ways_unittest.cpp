#include <gtest/gtest.h>

#include "cut_graph.h"
#include "place_on_paths.h"

namespace roomgraph::test {
namespace {

struct Ways {
  std::vector<Vertex> vertices{{{0, 0}, 1, VertexKind::deadEnd, {}},
                               {{4, 0}, 1, VertexKind::deadEnd, {}}};
  std::vector<Edge> edges{{VertexId(0), VertexId(1), straight({{0, 0}, {4, 0}}), {}}};
};

TEST(SplitAt, partsAnEdgeAtAPlaceOnIt) {
  Ways ways;
  EXPECT_EQ(splitAt(ways.vertices, ways.edges, {EdgeId(0), 1}, VertexKind::junction), VertexId(2));
  ASSERT_EQ(ways.edges.size(), 2u);
  EXPECT_EQ(ways.vertices[2].place, (Point{1, 0}));
  EXPECT_EQ(ways.vertices[2].kind, VertexKind::junction);
  EXPECT_EQ(ways.edges[0].source, VertexId(0));
  EXPECT_EQ(ways.edges[0].target, VertexId(2));
  EXPECT_EQ(ways.edges[1].target, VertexId(1));
  EXPECT_DOUBLE_EQ(ways.edges[1].path.length, 3);
}

TEST(SplitAt, itsEndsAreThereAlready) {
  Ways ways;
  EXPECT_EQ(splitAt(ways.vertices, ways.edges, {EdgeId(0), 0}, VertexKind::room), VertexId(0));
  EXPECT_EQ(splitAt(ways.vertices, ways.edges, {EdgeId(0), 4}, VertexKind::room), VertexId(1));
  EXPECT_EQ(ways.edges.size(), 1u);
  EXPECT_EQ(ways.vertices[0].kind, VertexKind::deadEnd);
}

}  // namespace
}  // namespace roomgraph::test
