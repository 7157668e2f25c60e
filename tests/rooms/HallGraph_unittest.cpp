#include "HallGraph.h"

#include <gtest/gtest.h>

#include "hand_built.h"

namespace roomgraph::test {
namespace {

/** A way from (0, 0) over (5, 0) to (5, 5), in an open room. */
class HallGraphTest : public testing::Test {
 protected:
  Room room_ = openRoom();
  ObstacleCells none_{{100, 100, 0.1, {-2, -2}}, {}};
  ObstacleRows obstacles_{none_};
  HallGraph ways_{straightWays({{0, 0}, {5, 0}, {5, 5}}, {{0, 1}, {1, 2}}), room_, obstacles_};

 private:
  static Room openRoom() {
    Room room;
    room.inscribedRadius = 5;
    return room;
  }
};

TEST_F(HallGraphTest, lengthsAreRightUpToTheMostThatIsAskedFor) {
  EXPECT_DOUBLE_EQ(ways_.lengthsFrom(VertexId(0), 10)[2], 10);
  EXPECT_GT(ways_.lengthsFrom(VertexId(0), 4)[2], 4);
  EXPECT_DOUBLE_EQ(ways_.lengthsFrom(VertexId(2), 5)[1], 5);
}

TEST_F(HallGraphTest, aStraightWayBeginsAndEndsOnTheWaysThereAre) {
  ways_.addStraight({2, 0}, {5, 4});
  EXPECT_EQ(ways_.size(), 5u);
  EXPECT_EQ(ways_.edges().size(), 5u);
  EXPECT_DOUBLE_EQ(ways_.lengthsFrom(VertexId(0), 10)[2], 2 + 5 + 1);
}

TEST_F(HallGraphTest, aWayThatCrossesAnotherMeetsItThere) {
  ways_.addDeadEnd({5, 2.5}, {0, 2.5});
  ways_.addStraight({2, 0}, {2, 2.5});
  EXPECT_EQ(ways_.size(), 7u);
  EXPECT_DOUBLE_EQ(ways_.lengthsFrom(VertexId(0), 20)[4], 2 + 2.5 + 2);
  const TopologyGraph graph = std::move(ways_).take();
  EXPECT_EQ(graph.edges().size(), 7u);
  EXPECT_EQ(graph.vertex(VertexId(4)).kind, VertexKind::deadEnd);
}

}  // namespace
}  // namespace roomgraph::test
