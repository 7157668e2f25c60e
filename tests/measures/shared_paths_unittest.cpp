#include "shared_paths.h"

#include <gtest/gtest.h>

#include "drawn_graph.h"

namespace roomgraph {
namespace {

/** Vertices at these places, joined by straight edges. */
TopologyGraph graphOf(const std::vector<Point>& places,
                      const std::vector<std::pair<std::size_t, std::size_t>>& joined) {
  std::vector<Vertex> vertices;
  for (const Point p : places) vertices.push_back({p, 1, VertexKind::junction, RoomId::none()});
  std::vector<Edge> edges;
  for (const auto& [a, b] : joined)
    edges.push_back(
        {VertexId(a), VertexId(b), makePath({places[a], places[b]}, {}), RoomId::none()});
  return {vertices, edges};
}

VertexMatch match(std::size_t a, std::size_t b) { return {VertexId(a), VertexId(b), 0}; }

TEST(IsSameLength, allowsSomeMetresAndAShareOfTheLongerOne) {
  const MatchGraphsOptions options;
  EXPECT_TRUE(isSameLength(1, 1.45, options)) << "half a metre";
  EXPECT_FALSE(isSameLength(1, 1.8, options));
  EXPECT_TRUE(isSameLength(10, 12, options)) << "a quarter";
  EXPECT_FALSE(isSameLength(10, 14, options));
  EXPECT_EQ(isSameLength(3, 9, options), isSameLength(9, 3, options));
}

TEST(SharedPaths, edgesOfOneLengthBetweenMatchedVerticesAreShared) {
  const TopologyGraph graph = graphOf({{0, 0}, {4, 0}, {4, 3}}, {{0, 1}, {1, 2}});
  const auto paths = sharedPaths(graph, graph, {match(0, 0), match(1, 1), match(2, 2)}, {});
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
  const TopologyGraph a = graphOf({{0, 0}, {4, 0}}, {{0, 1}});
  const TopologyGraph b = graphOf({{0, 0}, {4, 0}, {2, 0}}, {{0, 2}, {2, 1}});
  const auto paths = sharedPaths(a, b, {match(0, 0), match(1, 1)}, {});
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_EQ(paths[0].a.size(), 1u);
  EXPECT_EQ(paths[0].b.size(), 2u);
  EXPECT_NEAR(paths[0].lengthInB, 4, 1e-9);
}

TEST(SharedPaths, waysOfOtherLengthsAreNot) {
  const TopologyGraph a = graphOf({{0, 0}, {4, 0}}, {{0, 1}});
  const TopologyGraph b = graphOf({{0, 0}, {4, 0}, {2, 5}}, {{0, 2}, {2, 1}});
  EXPECT_TRUE(sharedPaths(a, b, {match(0, 0), match(1, 1)}, {}).empty());
}

TEST(SharedPaths, anEdgeIsSharedOnce) {
  // Two ways about as long between the same places, where the other graph has one.
  const TopologyGraph one = graphOf({{0, 0}, {4, 0}}, {{0, 1}});
  const TopologyGraph two = graphOf({{0, 0}, {4, 0}}, {{0, 1}, {0, 1}});
  EXPECT_EQ(sharedPaths(one, two, {match(0, 0), match(1, 1)}, {}).size(), 1u);
  EXPECT_EQ(sharedPaths(two, two, {match(0, 0), match(1, 1)}, {}).size(), 2u);
}

TEST(SharedPaths, withoutMatchesThereAreNone) {
  EXPECT_TRUE(sharedPaths(test::drawnGraph(), test::drawnGraph(), {}, {}).empty());
}

}  // namespace
}  // namespace roomgraph
