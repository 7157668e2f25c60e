#include "roomgraph/consensus/PoseGraph.h"

#include <gtest/gtest.h>

#include <cmath>

namespace roomgraph {
namespace {

constexpr double kExact = 1e-9;

/** The noise of a link that steps so far. */
PoseNoise linkNoise(const Transform2D& step) {
  PoseGraph graph;
  graph.addRun(true);
  const NodeId from = graph.addNode({}, {}, std::nullopt), to = graph.addNode(step, {}, {});
  graph.addLink(from, to);
  return graph.edges[PoseEdgeId(0)].noise;
}

TEST(PoseGraph, noiseOfALinkGrowsWithTheWayAndTheTurnWhateverItsDirection) {
  const PoseNoise rest = linkNoise({}), step = linkNoise({1, 0, 0}), turn = linkNoise({0, 0, 1});
  EXPECT_GT(rest.place, 0) << "a key frame is never exact";
  EXPECT_GT(rest.turn, 0);
  EXPECT_GT(step.place, rest.place);
  EXPECT_GT(step.turn, rest.turn) << "a way turns, too";
  EXPECT_EQ(turn.place, rest.place);
  EXPECT_GT(turn.turn, rest.turn);
  EXPECT_EQ(linkNoise({0, 0, -1}).turn, turn.turn);
  EXPECT_NEAR(linkNoise({0.6, -0.8, 0}).place, step.place, kExact);
}

TEST(PoseGraph, ofTwoLinksInARowTheVariancesAddUp) {
  const auto variance = [](const Transform2D& step) {
    const PoseNoise noise = linkNoise(step), rest = linkNoise({});
    return noise.place * noise.place - rest.place * rest.place;
  };
  EXPECT_NEAR(variance({5, 0, 0}), 5 * variance({1, 0, 0}), kExact);
}

TEST(PoseGraph, numbersNodesAndEdgesRunByRun) {
  PoseGraph graph;
  const RunId first = graph.addRun(true);
  const NodeId a = graph.addNode({1, 2, 0.5}, {}, {}), b = graph.addNode({2, 2, 0.5}, {}, {});
  graph.addLink(a, b);
  const RunId empty = graph.addRun(true), second = graph.addRun(false);
  const NodeId c = graph.addNode({}, {}, {}), d = graph.addNode({3, 0, 0}, {}, {});
  graph.addLink(c, d);
  EXPECT_EQ(graph.runs[first].nodes.size(), 2u);
  EXPECT_TRUE(graph.runs[empty].nodes.isEmpty());
  EXPECT_TRUE(graph.runs[empty].links.isEmpty());
  EXPECT_EQ(graph.runs[second].nodes.front(), c);
  EXPECT_EQ(graph.runs[second].links.size(), 1u);
  EXPECT_EQ(graph.runOf(b), first);
  EXPECT_EQ(graph.runOf(d), second);
  const PoseEdge& link = graph.edges[graph.runs[first].links.front()];
  EXPECT_FALSE(link.group);
  EXPECT_NEAR(link.measured.x, std::cos(0.5), kExact) << "as the run has its nodes to each other";
  EXPECT_NEAR(link.measured.y, -std::sin(0.5), kExact);
  EXPECT_EQ(graph.ownPoses()[d].x, 3);
}

TEST(PoseGraph, aGroupMayJoinTwoRunsOrTwoPlacesOfOne) {
  PoseGraph graph;
  const RunId run = graph.addRun(true);
  const NodeId a = graph.addNode({}, {}, {}), b = graph.addNode({1, 0, 0}, {}, {});
  graph.addLink(a, b);
  graph.addGroup({run, run, {}}, {matchEdge(a, b, {2, 0, 0}, 0.7), sameScanEdge(b, a)});
  const MatchGroup& group = graph.groups[MatchGroupId(0)];
  ASSERT_EQ(group.edges.size(), 2u);
  EXPECT_EQ(graph.edges[group.edges.front()].group, MatchGroupId(0));
  EXPECT_EQ(graph.edges[group.edges.front()].share, 0.7);
  EXPECT_TRUE(graph.edges[group.edges.back()].isSameScan);
  EXPECT_EQ(graph.runs[run].links.size(), 1u) << "matches are no links";
}

TEST(HalvesOf, bothEndsSeeTheSameEdge) {
  const PoseEdge edge = matchEdge(NodeId(3), NodeId(7), {1, 2, 0.5}, 1);
  const auto [to, from] = halvesOf(edge);
  EXPECT_EQ(to.node, NodeId(7));
  EXPECT_EQ(to.other, NodeId(3));
  EXPECT_EQ(from.node, NodeId(3));
  const Transform2D back = to.measured * from.measured;
  EXPECT_NEAR(norm(back.shift()), 0, kExact);
  EXPECT_NEAR(back.phi, 0, kExact);
}

}  // namespace
}  // namespace roomgraph
