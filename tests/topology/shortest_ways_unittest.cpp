#include "roomgraph/topology/shortest_ways.h"

#include <gtest/gtest.h>

#include "hand_built.h"

namespace roomgraph::test {
namespace {

/** From (0, 0) to (8, 0) straight on, or round by (4, 3); and a part of its own. */
TopologyGraph twoWays() {
  const auto edge = [](std::size_t from, std::size_t to, Polyline points) {
    return Edge{VertexId(from), VertexId(to), straight(points), {}};
  };
  return {{{{0, 0}, 1, VertexKind::junction, {}},
           {{8, 0}, 1, VertexKind::junction, {}},
           {{0, 9}, 1, VertexKind::deadEnd, {}},
           {{8, 9}, 1, VertexKind::deadEnd, {}}},
          {edge(0, 1, {{0, 0}, {4, 3}, {8, 0}}), edge(0, 1, {{0, 0}, {8, 0}}),
           edge(2, 3, {{0, 9}, {8, 9}})}};
}

const std::vector<EdgeId> kAll{EdgeId(0), EdgeId(1), EdgeId(2)};

TEST(ShortestWays, takeTheShorterOfTwo) {
  const TopologyGraph graph = twoWays();
  const ShortestWays ways(graph, kAll, {EdgeId(1), 2});
  EXPECT_DOUBLE_EQ(ways.pathTo(VertexId(1)).length, 6);
  EXPECT_DOUBLE_EQ(ways.pathTo(VertexId(0)).length, 2);
  EXPECT_EQ(ways.pathTo(VertexId(1)).points, (Polyline{{2, 0}, {8, 0}}));
}

TEST(ShortestWays, goRoundWhereThatIsAllThereIs) {
  const TopologyGraph graph = twoWays();
  const ShortestWays ways(graph, {EdgeId(0)}, {EdgeId(0), 0});
  EXPECT_DOUBLE_EQ(ways.pathTo(VertexId(1)).length, 10);
  EXPECT_EQ(ways.pathTo(VertexId(1)).points.size(), 3u);
}

TEST(ShortestWays, doNotReachAnotherPart) {
  const TopologyGraph graph = twoWays();
  const ShortestWays ways(graph, kAll, {EdgeId(0), 1});
  EXPECT_TRUE(ways.reaches(VertexId(1)));
  EXPECT_FALSE(ways.reaches(VertexId(2)));
}

}  // namespace
}  // namespace roomgraph::test
