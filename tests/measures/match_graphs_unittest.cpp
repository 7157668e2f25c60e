#include "match_graphs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "drawn_graph.h"

namespace roomgraph {
namespace {

using test::bentAt;
using test::drawnGraph;
using test::everywhere;
using test::moved;
using test::patchesOver;
using test::withoutVertex;

using Numbers = std::vector<std::pair<std::size_t, std::size_t>>;

Numbers numbersOf(const GraphMatch& match) {
  Numbers numbers;
  for (const VertexMatch& m : match.vertices) numbers.push_back({m.a.index(), m.b.index()});
  return numbers;
}

GraphMatch matched(const TopologyGraph& a, const TopologyGraph& b, const Transform2D& bFromA) {
  const WallPatches inA = patchesOver({}), inB = patchesOver(bFromA);
  return matchGraphs({a, inA, everywhere(inA, bFromA)},
                     {b, inB, everywhere(inB, bFromA.inverse())});
}

TEST(MatchGraphs, aGraphMatchesItselfInAnyPose) {
  const TopologyGraph graph = drawnGraph();
  const Transform2D pose{5, -3, 2};
  const GraphMatch match = matched(graph, moved(graph, pose), pose);
  ASSERT_EQ(match.vertices.size(), graph.vertices().size());
  for (const VertexMatch& m : match.vertices) {
    EXPECT_EQ(m.a, m.b);
    EXPECT_NEAR(m.distance, 0, 1e-9);
  }
  EXPECT_EQ(match.paths.size(), graph.edges().size());
  EXPECT_GT(match.overallInA, 30);
  EXPECT_NEAR(match.sharedInA, match.overallInA, 1e-9);
  EXPECT_NEAR(match.sharedInB, match.overallInB, 1e-9);
}

TEST(MatchGraphs, theNearestVertexIsNotTakenWhereItLooksDifferent) {
  const TopologyGraph a = drawnGraph();
  // Vertex 8 of b stands right where vertex 1 of a is, but it is a dead end on its own.
  std::vector<Vertex> vertices = moved(a, {0.4, 0, 0}).vertices();
  std::vector<Edge> edges = moved(a, {0.4, 0, 0}).edges();
  vertices.push_back({a.vertices()[1].place, 1, VertexKind::deadEnd, RoomId::none()});
  vertices.push_back({a.vertices()[1].place + Point{0, 2}, 1, VertexKind::deadEnd, RoomId::none()});
  const std::size_t n = a.vertices().size();
  edges.push_back({VertexId(n), VertexId(n + 1),
                   makePath({vertices[n].place, vertices[n + 1].place}, {}), RoomId::none()});
  const Numbers found = numbersOf(matched(a, {vertices, edges}, {}));
  EXPECT_TRUE(
      std::count(found.begin(), found.end(), std::make_pair(std::size_t(1), std::size_t(1))));
}

TEST(MatchGraphs, bentMapsMatchByThePosesOfTheirWalls) {
  const TopologyGraph a = drawnGraph();
  const Transform2D far = carrying({10, 0}, {10, 0}, 0.3);  // what lies beyond x = 10
  const TopologyGraph b = bentAt(a, 10, far);
  const WallPatches inA = patchesOver({}), inB = inA;
  FollowedWalls there = everywhere(inA, {}), back = everywhere(inB, {});
  for (FollowedPatch& f : there.patches)
    if (inA[f.patch].middle.x > 10) f.pose = far;
  for (FollowedPatch& f : back.patches)
    if (inB[f.patch].middle.x > 10) f.pose = far.inverse();
  const GraphMatch match = matchGraphs({a, inA, there}, {b, inB, back});
  EXPECT_EQ(match.vertices.size(), a.vertices().size());
  for (const VertexMatch& m : match.vertices) EXPECT_EQ(m.a, m.b);
  EXPECT_LT(matched(a, b, {}).vertices.size(), a.vertices().size());
}

TEST(MatchGraphs, aWayPastAVertexThatOnlyOneGraphHasIsShared) {
  const TopologyGraph a = drawnGraph();
  const TopologyGraph b = withoutVertex(a, VertexId(2));  // one of degree two
  const GraphMatch match = matched(a, b, {});
  EXPECT_EQ(match.vertices.size(), b.vertices().size());
  const auto past = std::find_if(match.paths.begin(), match.paths.end(),
                                 [](const PathMatch& path) { return path.a.size() == 2; });
  ASSERT_NE(past, match.paths.end());
  EXPECT_EQ(past->b.size(), 1u);
  EXPECT_NEAR(past->lengthInA, past->lengthInB, 1e-9);
  EXPECT_NEAR(match.sharedInA, match.overallInA, 1e-9);
  EXPECT_NEAR(match.sharedInB, match.overallInB, 1e-9);
}

TEST(MatchGraphs, swappingTheGraphsSwapsTheAnswer) {
  const TopologyGraph a = drawnGraph();
  const TopologyGraph b = withoutVertex(moved(a, {0.3, 0.2, 0.02}), VertexId(2));
  const GraphMatch there = matched(a, b, {}), back = matched(b, a, {});
  Numbers swapped = numbersOf(back);
  for (auto& pair : swapped) std::swap(pair.first, pair.second);
  std::sort(swapped.begin(), swapped.end());
  EXPECT_EQ(numbersOf(there), swapped);
  EXPECT_DOUBLE_EQ(there.sharedInA, back.sharedInB);
  EXPECT_DOUBLE_EQ(there.sharedInB, back.sharedInA);
}

TEST(MatchGraphs, roomsMatchRoomsOnly) {
  const Vertex room{{3, 3}, 1, VertexKind::room, RoomId(0)};
  const Vertex junction{{3, 3}, 1, VertexKind::junction, RoomId::none()};
  EXPECT_TRUE(matched({{room}, {}}, {{junction}, {}}, {}).vertices.empty());
  EXPECT_EQ(matched({{room}, {}}, {{room}, {}}, {}).vertices.size(), 1u);
}

TEST(MatchGraphs, nothingMatchesWhereNoWallWasFollowed) {
  const TopologyGraph graph = drawnGraph();
  const WallPatches patches = patchesOver({});
  const GraphMatch match = matchGraphs({graph, patches, {}}, {graph, patches, {}});
  EXPECT_TRUE(match.vertices.empty());
  EXPECT_EQ(match.sharedInA, 0);
  EXPECT_GT(match.overallInA, 0);
  EXPECT_TRUE(matched({}, {}, {}).vertices.empty());
}

}  // namespace
}  // namespace roomgraph
