#include "shared_paths.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_graph.h"
#include "hand_built.h"

namespace roomgraph {
namespace {

VertexMatch match(std::size_t a, std::size_t b) { return {VertexId(a), VertexId(b), 0}; }

TEST(IsSameLength, allowsSomeMetresAndAShareOfTheLongerOne) {
  EXPECT_TRUE(isSameLength(1, 1.45)) << "half a metre";
  EXPECT_FALSE(isSameLength(1, 1.8));
  EXPECT_TRUE(isSameLength(10, 12)) << "a quarter";
  EXPECT_FALSE(isSameLength(10, 14));
  EXPECT_EQ(isSameLength(3, 9), isSameLength(9, 3));
}

TEST(SharedPaths, edgesOfOneLengthBetweenMatchedVerticesAreShared) {
  const TopologyGraph graph = test::straightWays({{0, 0}, {4, 0}, {4, 3}}, {{0, 1}, {1, 2}});
  const auto paths = sharedPaths(graph, graph, {match(0, 0), match(1, 1), match(2, 2)});
  ASSERT_EQ(paths.size(), 2u);
  EXPECT_EQ(paths[0].from, 0u);
  EXPECT_EQ(paths[0].to, 1u);
  EXPECT_NEAR(paths[0].lengthInA, 4, 1e-9);
  EXPECT_EQ(paths[1].from, 1u);
  EXPECT_NEAR(paths[1].lengthInB, 3, 1e-9);
  ASSERT_EQ(paths[0].a.size(), 1u);
  EXPECT_EQ(graph.target(paths[0].a[0]), VertexId(1));
}

TEST(SharedPaths, aWayThroughAVertexThatIsNotMatchedIsShared) {
  const TopologyGraph a = test::straightWays({{0, 0}, {4, 0}}, {{0, 1}});
  const TopologyGraph b = test::straightWays({{0, 0}, {4, 0}, {2, 0}}, {{0, 2}, {2, 1}});
  const auto paths = sharedPaths(a, b, {match(0, 0), match(1, 1)});
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_EQ(paths[0].a.size(), 1u);
  EXPECT_EQ(paths[0].b.size(), 2u);
  EXPECT_NEAR(paths[0].lengthInB, 4, 1e-9);
}

TEST(SharedPaths, waysOfOtherLengthsAreNot) {
  const TopologyGraph a = test::straightWays({{0, 0}, {4, 0}}, {{0, 1}});
  const TopologyGraph b = test::straightWays({{0, 0}, {4, 0}, {2, 5}}, {{0, 2}, {2, 1}});
  EXPECT_TRUE(sharedPaths(a, b, {match(0, 0), match(1, 1)}).empty());
}

TEST(SharedPaths, anEdgeIsSharedOnce) {
  // Two ways about as long between the same places, where the other graph has one.
  const TopologyGraph one = test::straightWays({{0, 0}, {4, 0}}, {{0, 1}});
  const TopologyGraph two = test::straightWays({{0, 0}, {4, 0}}, {{0, 1}, {0, 1}});
  EXPECT_EQ(sharedPaths(one, two, {match(0, 0), match(1, 1)}).size(), 1u);
  EXPECT_EQ(sharedPaths(two, two, {match(0, 0), match(1, 1)}).size(), 2u);
}

TEST(SharedPaths, withoutMatchesThereAreNone) {
  EXPECT_TRUE(sharedPaths(test::drawnGraph(), test::drawnGraph(), {}).empty());
}

TEST(SharedPaths, areTheSameFromTheOtherSide) {
  const TopologyGraph a =
      test::straightWays({{0, 0}, {4, 0}, {4, 3}, {0, 3}}, {{0, 1}, {1, 2}, {2, 3}});
  const TopologyGraph b = test::straightWays({{0, 0}, {4, 0}, {4, 3}, {0, 3}, {4, 1.5}},
                                             {{0, 1}, {1, 4}, {4, 2}, {3, 0}});
  std::vector<VertexMatch> there, back;
  for (std::size_t v = 0; v < 4; ++v) there.push_back(match(v, v)), back.push_back(match(v, v));
  const auto forth = sharedPaths(a, b, there), other = sharedPaths(b, a, back);
  ASSERT_EQ(forth.size(), other.size());
  EXPECT_EQ(forth.size(), 2u) << "bottom and right: the top and the left side are in one only";
  for (std::size_t p = 0; p < forth.size(); ++p) {
    EXPECT_EQ(forth[p].from, other[p].from);
    EXPECT_EQ(forth[p].lengthInA, other[p].lengthInB);
    EXPECT_EQ(forth[p].a.size(), other[p].b.size());
  }
}

TEST(SharedPaths, stepsLeadFromTheOneEndToTheOther) {
  const TopologyGraph graph = test::drawnGraph();
  std::vector<VertexMatch> some;
  for (std::size_t v = 0; v < graph.vertices().size(); v += 2) some.push_back(match(v, v));
  const auto paths = sharedPaths(graph, graph, some);
  ASSERT_FALSE(paths.empty());
  for (const PathMatch& path : paths) {
    ASSERT_FALSE(path.a.empty());
    EXPECT_LE(path.from, path.to);
    EXPECT_EQ(graph.source(path.a.front()), some[path.from].a);
    EXPECT_EQ(graph.target(path.a.back()), some[path.to].a);
    double length = 0;
    for (std::size_t k = 0; k < path.a.size(); ++k) {
      length += graph.edge(path.a[k]).path.length;
      if (k > 0) {
        EXPECT_EQ(graph.source(path.a[k]), graph.target(path.a[k - 1]));
      }
      for (const VertexMatch& other : some)
        if (k > 0) {
          EXPECT_NE(graph.source(path.a[k]), other.a) << "past no matched vertex";
        }
    }
    EXPECT_NEAR(length, path.lengthInA, 1e-9);
    EXPECT_EQ(path.a, path.b) << "of a graph in itself";
  }
}

TEST(SharedPaths, aWayThatIsTooLongIsNotLookedFor) {
  const auto found = [](double length) {
    const TopologyGraph graph =
        test::straightWays({{0, 0}, {length / 2, 0}, {length, 0}}, {{0, 1}, {1, 2}});
    return sharedPaths(graph, graph, {match(0, 0), match(2, 2)}).size();
  };
  EXPECT_EQ(found(19), 1u);
  EXPECT_EQ(found(21), 0u);
}

TEST(SharedPaths, ofTwoWaysTheShorterCounts) {
  const TopologyGraph a =
      test::straightWays({{0, 0}, {4, 0}, {2, 0.5}, {2, -2}}, {{0, 2}, {2, 1}, {0, 3}, {3, 1}});
  const auto paths = sharedPaths(a, a, {match(0, 0), match(1, 1)});
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_NEAR(paths[0].lengthInA, 2 * std::hypot(2, 0.5), 1e-9);
}

}  // namespace
}  // namespace roomgraph
