#include <gtest/gtest.h>

#include "hand_built.h"
#include "roomgraph/topology/dead_ends.h"
#include "roomgraph/topology/invariants.h"
#include "roomgraph/topology/join_vertices.h"
#include "roomgraph/topology/keep_largest.h"

namespace roomgraph::test {
namespace {

constexpr auto kJunction = VertexKind::junction;
constexpr auto kDeadEnd = VertexKind::deadEnd;

TEST(RemoveDeadEnds, removesThemLayerByLayer) {
  // A twig with two short tips goes as a whole: first its tips, then itself.
  const TopologyGraph tree({{{0, 0}, 0.5, kJunction, {}},
                            {{9, 0}, 0.5, kDeadEnd, {}},
                            {{0, 9}, 0.5, kDeadEnd, {}},
                            {{-0.4, 0}, 0.3, kJunction, {}},
                            {{-0.6, 0.1}, 0.2, kDeadEnd, {}},
                            {{-0.6, -0.1}, 0.2, kDeadEnd, {}}},
                           {{VertexId(0), VertexId(1), straight({{0, 0}, {9, 0}}), {}},
                            {VertexId(0), VertexId(2), straight({{0, 0}, {0, 9}}), {}},
                            {VertexId(0), VertexId(3), straight({{0, 0}, {-0.4, 0}}), {}},
                            {VertexId(3), VertexId(4), straight({{-0.4, 0}, {-0.6, 0.1}}), {}},
                            {VertexId(3), VertexId(5), straight({{-0.4, 0}, {-0.6, -0.1}}), {}}});
  const TopologyGraph pruned = removeDeadEnds(tree, {}, 0.1);
  EXPECT_EQ(pruned.vertices().size(), 2u);
  ASSERT_EQ(pruned.edges().size(), 1u);
  EXPECT_DOUBLE_EQ(pruned.edges()[0].path.length, 18);
}

TEST(RemoveDeadEnds, measuresTheReachBeyondTheJunctionsDisc) {
  DeadEndsOptions options;
  options.minReachRatio = 0.5;
  options.minReach = 0;
  // The tips' clearance is that of hand_built's obstacles, 1; so the reach is the length.
  EXPECT_EQ(removeDeadEnds(star({0.4, 3, 4}), options, 0.1).edges().size(), 1u);
  EXPECT_EQ(removeDeadEnds(star({0.6, 3, 4}), options, 0.1).edges().size(), 3u);
}

TEST(RemoveDeadEnds, neverRemovesAWholeComponent) {
  const TopologyGraph kept = removeDeadEnds(star({0.1, 0.1, 0.1}), {}, 0.1);
  EXPECT_EQ(kept.vertices().size(), 1u);
  EXPECT_TRUE(kept.edges().empty());
  const TopologyGraph line({{{0, 0}, 1, kDeadEnd, {}}, {{0.1, 0}, 1, kDeadEnd, {}}},
                           {{VertexId(0), VertexId(1), straight({{0, 0}, {0.1, 0}}), {}}});
  EXPECT_EQ(removeDeadEnds(line, {}, 0.1).edges().size(), 1u);
}

TEST(RemoveDeadEnds, thePapersWayRemovesEachOnceThenTheShort) {
  DeadEndsOptions options;
  options.allOnce = true;
  options.minLengthPx = 8;
  EXPECT_TRUE(removeDeadEnds(star({2, 3, 4}), options, 0.1).edges().empty());
  options.allOnce = false;
  EXPECT_EQ(removeDeadEnds(star({0.7, 3, 4}), options, 0.1).edges().size(), 1u);
  EXPECT_EQ(removeDeadEnds(star({0.9, 3, 4}), options, 0.1).edges().size(), 3u);
}

/** Two stars whose centres are `gap` apart. */
TopologyGraph twoStars(double gap) {
  return {{{{0, 0}, 1, kJunction, {}},
           {{gap, 0}, 1, kJunction, {}},
           {{-3, 1}, 1, kDeadEnd, {}},
           {{-3, -1}, 1, kDeadEnd, {}},
           {{5, 1}, 1, kDeadEnd, {}},
           {{5, -1}, 1, kDeadEnd, {}}},
          {{VertexId(0), VertexId(1), straight({{0, 0}, {gap, 0}}), {}},
           {VertexId(0), VertexId(2), straight({{0, 0}, {-3, 1}}), {}},
           {VertexId(0), VertexId(3), straight({{0, 0}, {-3, -1}}), {}},
           {VertexId(1), VertexId(4), straight({{gap, 0}, {5, 1}}), {}},
           {VertexId(1), VertexId(5), straight({{gap, 0}, {5, -1}}), {}}}};
}

TEST(JoinVertices, makesOneOfTwoThatAreNear) {
  JoinVerticesOptions options;
  options.maxDistance = 0.2;
  const TopologyGraph near = joinVertices(twoStars(0.15), options, 0.1);
  EXPECT_EQ(near.vertices().size(), 5u);
  EXPECT_EQ(near.edges().size(), 4u);
  EXPECT_TRUE(brokenInvariants(near, 0).empty());
  EXPECT_EQ(joinVertices(twoStars(0.25), options, 0.1).vertices().size(), 6u);
}

TEST(JoinVertices, countsInCellsWhereAsked) {
  JoinVerticesOptions options;
  options.maxDistance = 0;
  options.maxDistancePx = 4;
  EXPECT_EQ(joinVertices(twoStars(0.35), options, 0.1).vertices().size(), 5u);
  EXPECT_EQ(joinVertices(twoStars(0.45), options, 0.1).vertices().size(), 6u);
}

TEST(JoinVertices, leavesTheTipsOfDeadEnds) {
  EXPECT_EQ(joinVertices(star({0.05, 2, 3}), {}, 0.1).edges().size(), 3u);
}

TEST(JoinVertices, makesASelfLoopOfAWayRoundAnObstacle) {
  JoinVerticesOptions options;
  options.maxDistance = 0.2;
  const TopologyGraph graph =
      joinVertices({{{{0, 0}, 1, kJunction, {}},
                     {{0.1, 0}, 1, kJunction, {}},
                     {{-3, 0}, 1, kDeadEnd, {}},
                     {{3, 0}, 1, kDeadEnd, {}}},
                    {{VertexId(0), VertexId(1), straight({{0, 0}, {0.1, 0}}), {}},
                     {VertexId(0), VertexId(1), straight({{0, 0}, {0, 2}, {0.1, 2}, {0.1, 0}}), {}},
                     {VertexId(0), VertexId(2), straight({{0, 0}, {-3, 0}}), {}},
                     {VertexId(1), VertexId(3), straight({{0.1, 0}, {3, 0}}), {}}}},
                   options, 0.1);
  EXPECT_EQ(graph.vertices().size(), 3u);
  ASSERT_EQ(graph.edges().size(), 3u);
  EXPECT_EQ(graph.edges()[0].source, graph.edges()[0].target);
  EXPECT_TRUE(brokenInvariants(graph, 0).empty());
}

/** Three lines that are not connected, 5, 2 and 0.5 m long. */
TopologyGraph threeLines() {
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  double y = 0;
  for (const double along : {2.0, 5.0, 0.5}) {
    vertices.push_back({{0, y}, 1, kDeadEnd, {}});
    vertices.push_back({{along, y}, 1, kDeadEnd, {}});
    edges.push_back({VertexId(vertices.size() - 2),
                     VertexId(vertices.size() - 1),
                     straight({{0, y}, {along, y}}),
                     {}});
    y += 10;
  }
  return {vertices, edges};
}

TEST(KeepLargest, keepsTheLongestAndTellsOfTheOthers) {
  Notes notes;
  const TopologyGraph kept = keepLargest(threeLines(), {}, notes);
  ASSERT_EQ(kept.edges().size(), 1u);
  EXPECT_DOUBLE_EQ(kept.edges()[0].path.length, 5);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].code, "component_dropped");
  EXPECT_NE(notes[0].text.find("2 parts"), std::string::npos);
  EXPECT_NE(notes[0].text.find("2.5 m"), std::string::npos);
  ASSERT_TRUE(notes[0].where);
  EXPECT_EQ((*notes[0].where)[1], 0);
}

TEST(KeepLargest, keepsAllFromTheLimitUp) {
  Notes notes;
  KeepLargestOptions options;
  options.allComponents = true;
  options.minLength = 1;
  EXPECT_EQ(keepLargest(threeLines(), options, notes).edges().size(), 2u);
  EXPECT_EQ(notes.size(), 1u);
  options.minLength = 0;
  notes.clear();
  EXPECT_EQ(keepLargest(threeLines(), options, notes).edges().size(), 3u);
  EXPECT_TRUE(notes.empty());
}

TEST(KeepLargest, takesTheWidestWhereNoneHasLength) {
  Notes notes;
  const TopologyGraph kept =
      keepLargest({{{{0, 0}, 1, kJunction, {}}, {{5, 0}, 2, kJunction, {}}}, {}}, {}, notes);
  ASSERT_EQ(kept.vertices().size(), 1u);
  EXPECT_EQ(kept.vertices()[0].clearance, 2);
  EXPECT_TRUE(keepLargest({}, {}, notes).vertices().empty());
}

}  // namespace
}  // namespace roomgraph::test
