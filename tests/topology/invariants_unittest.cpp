#include "invariants.h"

#include <gtest/gtest.h>

#include "hand_built.h"

namespace roomgraph::test {
namespace {

TEST(Invariants, nameWhatIsWrong) {
  std::vector<Vertex> vertices{{{0, 0}, 1, kDeadEnd, {}}, {{4, 0}, 1, kDeadEnd, {}}};
  const Path good = straight({{0, 0}, {4, 0}});
  const auto broken = [&](const Path& path, double clearance) {
    return test::brokenInvariants({vertices, {{VertexId(0), VertexId(1), path, {}}}}, clearance)
        .size();
  };
  EXPECT_EQ(broken(good, 0.5), 0u);
  EXPECT_EQ(broken(good, 1.5), 1u);
  Path tooLong = good;
  tooLong.length = 5;
  EXPECT_EQ(broken(tooLong, 0), 1u);
  EXPECT_EQ(broken(straight({{0, 0}, {3, 0}}), 0), 1u);
  vertices[1].place.x = std::nan("");
  EXPECT_GE(broken(good, 0), 1u);
  vertices[1].place = {0, 0};
  Path point;
  point.points = {{0, 0}};
  EXPECT_EQ(broken(point, 0), 1u);
}

TEST(Invariants, seePathsThatCross) {
  const TopologyGraph graph = straightWays({{0, 0}, {4, 4}, {0, 4}, {4, 0}}, {{0, 1}, {2, 3}});
  EXPECT_EQ(test::brokenInvariants(graph, 0).size(), 1u);
}

TEST(Invariants, pathsMayMeetInAVertexOrTouch) {
  EXPECT_TRUE(test::brokenInvariants(star({2, 3, 4}), 0).empty());
  const TopologyGraph touching = straightWays({{0, 0}, {4, 0}, {2, 0}, {2, 4}}, {{0, 1}, {2, 3}});
  EXPECT_TRUE(test::brokenInvariants(touching, 0).empty());
}

TEST(Invariants, seeADeadEndWithTwoWays) {
  const TopologyGraph graph =
      joinedUp({{{0, 0}, 1, kDeadEnd, {}}, {{4, 0}, 1, kDeadEnd, {}}, {{8, 0}, 1, kDeadEnd, {}}},
               {{0, 1}, {1, 2}});
  ASSERT_EQ(test::brokenInvariants(graph, 0).size(), 1u);
  EXPECT_NE(test::brokenInvariants(graph, 0)[0].find("1"), std::string::npos) << "which one";
}

}  // namespace
}  // namespace roomgraph::test
