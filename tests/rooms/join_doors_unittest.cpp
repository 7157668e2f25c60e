#include "roomgraph/rooms/join_doors.h"

#include <gtest/gtest.h>

#include "cut_graph.h"
#include "invariants.h"

namespace roomgraph::test {
namespace {

/** A path from room 0 at the origin to room 1 through a door `depth` deep. */
TopologyGraph throughADoor(double depth) {
  return cutAtRooms(line({{2, 2}, {6 + depth, 2}}), {squareRoom(0, 0), squareRoom(4 + depth, 0)});
}

TEST(JoinDoors, makesOneBorderVertexOfAShallowDoor) {
  JoinDoorsOptions options;
  options.maxDepth = 0.5;
  const TopologyGraph joined = joinDoors(throughADoor(0.4), options);
  EXPECT_EQ(countOf(joined, VertexKind::border), 1u);
  ASSERT_EQ(joined.edges().size(), 2u);
  for (const Vertex& v : joined.vertices())
    EXPECT_TRUE(v.kind != VertexKind::border || distance(v.place, {4.2, 2}) < 1e-12);
  EXPECT_TRUE(test::brokenInvariants(joined, 0).empty());
  EXPECT_EQ(countOf(joinDoors(throughADoor(0.6), options), VertexKind::border), 2u);
  options.maxDepth = 0;
  EXPECT_EQ(countOf(joinDoors(throughADoor(0.4), options), VertexKind::border), 2u);
}

TEST(JoinDoors, leavesADoorBackIntoTheSameRoom) {
  const TopologyGraph cut =
      cutAtRooms(line({{2, 1}, {4.1, 1}, {4.1, 1.2}, {2, 1.2}}), {squareRoom(0, 0)});
  JoinDoorsOptions options;
  options.maxDepth = 1;
  EXPECT_EQ(joinDoors(cut, options).edges().size(), cut.edges().size());
}

TEST(JoinDoors, keepsTheWayAsLongAsItWas) {
  JoinDoorsOptions options;
  options.maxDepth = 0.5;
  const TopologyGraph joined = joinDoors(throughADoor(0.4), options);
  double sum = 0;
  for (const Edge& edge : joined.edges()) sum += edge.path.length;
  EXPECT_NEAR(sum, 4.4, 1e-9);
}

TEST(JoinDoors, leavesADoorWithABranch) {
  const TopologyGraph graph =
      straightWays({{2, 2}, {4.2, 2}, {6.4, 2}, {4.2, 9}}, {{0, 1}, {1, 2}, {1, 3}});
  const TopologyGraph cut = cutAtRooms(graph, {squareRoom(0, 0), squareRoom(4.4, 0)});
  JoinDoorsOptions options;
  options.maxDepth = 0.5;
  EXPECT_EQ(countOf(joinDoors(cut, options), VertexKind::border), 2u);
}

}  // namespace
}  // namespace roomgraph::test
