#include "roomgraph/rooms/short_dead_ends.h"

#include <gtest/gtest.h>

#include "cut_graph.h"

namespace roomgraph::test {
namespace {

/** A path from the middle of a room through its right side to `x`. */
TopologyGraph outTo(double x) { return cutAtRooms(line({{2, 2}, {x, 2}}), {squareRoom(0, 0)}); }

TEST(RemoveShortDeadEnds, takesTheBorderVertexWithIt) {
  const TopologyGraph gone = removeShortDeadEnds(outTo(4.9), 1);
  EXPECT_EQ(countOf(gone, VertexKind::border), 0u);
  EXPECT_EQ(gone.edges().size(), 1u);
  const TopologyGraph kept = removeShortDeadEnds(outTo(5.1), 1);
  EXPECT_EQ(countOf(kept, VertexKind::border), 1u);
  EXPECT_EQ(kept.edges().size(), 2u);
}

TEST(RemoveShortDeadEnds, takesAShortWayBackIntoTheSameRoom) {
  const auto outAndBack = [](double depth) {
    const TopologyGraph graph(
        {{{2, 1}, 1, VertexKind::junction, {}}, {{1, 1}, 1, VertexKind::deadEnd, {}}},
        {{VertexId(0),
          VertexId(0),
          straight({{2, 1}, {4 + depth, 1}, {4 + depth, 1.2}, {2, 1}}),
          {}},
         {VertexId(0), VertexId(1), straight({{2, 1}, {1, 1}}), {}}});
    return removeShortDeadEnds(cutAtRooms(graph, {squareRoom(0, 0)}), 1);
  };
  EXPECT_EQ(countOf(outAndBack(0.3), VertexKind::border), 0u);
  EXPECT_EQ(countOf(outAndBack(2), VertexKind::border), 2u);
}

TEST(RemoveShortDeadEnds, leavesThoseThatDoNotStartAtARoom) {
  EXPECT_EQ(removeShortDeadEnds(star({0.2, 3, 4}), 1).edges().size(), 3u);
}

TEST(RemoveShortDeadEnds, theLimitIsGivenInMetresOrInCells) {
  ShortDeadEndsOptions options;
  options.minLength = 0.7;
  EXPECT_DOUBLE_EQ(shortLength(options, 0.05), 0.7);
  options.minLengthPx = 20;
  EXPECT_DOUBLE_EQ(shortLength(options, 0.05), 1);
}

}  // namespace
}  // namespace roomgraph::test
