#include "edge_cost.h"

#include <gtest/gtest.h>

#include <cmath>

#include "RandomNumbers.h"
#include "drawn_pose_graph.h"

namespace roomgraph {
namespace {

constexpr double kExactCost = 1e-9;

/** Of nodes that lie to each other as `found`, and not as `measured`. */
double costOf(const EdgeTerm& term, const Transform2D& measured, const Transform2D& found) {
  NodePoses poses;
  poses.add({}), poses.add(found);
  return term.cost(gapOf(matchEdge(NodeId(0), NodeId(1), measured, 1), poses));
}

/** A term as wide as it is exact, of an edge that was measured so. */
struct Edge {
  Transform2D measured;
  EdgeTerm term{{0.02, 0.1}, 3, 1};

  double cost(const Transform2D& from, const Transform2D& to) const {
    return costOf(term, measured, from.inverse() * to);
  }
};

TEST(EdgeTerm, costsNothingWhereThePosesAreAsMeasured) {
  test::RandomNumbers random(1);
  for (int i = 0; i < 50; ++i) {
    const Transform2D measured = random.pose(5), from = random.pose(50);
    EXPECT_NEAR(Edge{measured}.cost(from, from * measured), 0, kExactCost);
  }
}

TEST(EdgeTerm, theFrameOfTheSiteChangesNothing) {
  test::RandomNumbers random(2);
  for (int i = 0; i < 50; ++i) {
    const Edge t{random.pose(2)};
    const Transform2D from = random.pose(5), to = random.pose(5), motion = random.pose(30);
    EXPECT_NEAR(t.cost(motion * from, motion * to), t.cost(from, to), 1e-6);
  }
}

TEST(EdgeTerm, theSameMatchSeenFromItsOtherNodeCostsAsMuch) {
  test::RandomNumbers random(3);
  for (int i = 0; i < 50; ++i) {
    const Transform2D measured = random.pose(2), from = random.pose(5);
    // What is shifted only: a turn is about the one submap or about the other.
    const Point off = random.place(1);
    const Transform2D found = from * measured, to{found.x + off.x, found.y + off.y, found.phi};
    EXPECT_NEAR(Edge{measured.inverse()}.cost(to, from), Edge{measured}.cost(from, to), 1e-6);
  }
}

TEST(EdgeTerm, isHalfTheSquareForWhatIsLittleOff) {
  const Edge t{{1, 0, 0}};
  EXPECT_NEAR(t.cost({}, {1.01, 0, 0}), 0.5 * 0.1 * 0.1, 1e-4);
  EXPECT_NEAR(t.cost({}, {1, 0, 0.004}), 0.5 * 0.2 * 0.2, 1e-3);
  EXPECT_NEAR(t.cost({}, {1, -0.01, 0}), t.cost({}, {1, 0.01, 0}), kExactCost);
}

TEST(EdgeTerm, letsGoOfWhatIsFarOff) {
  const Edge t{{}};
  double last = 0, gain = HUGE_VAL;
  for (const double off : {1.0, 2.0, 4.0, 8.0, 16.0}) {
    const double cost = t.cost({}, {off, 0, 0});
    EXPECT_GT(cost, last) << off;
    EXPECT_LT(cost, 0.5 * off * off / 0.1 / 0.1) << "less than its square";
    if (off > 2) {
      EXPECT_LE(cost - last, 1.05 * gain) << "each doubling costs about the same";
    }
    gain = cost - last, last = cost;
  }
}

TEST(EdgeTerm, aTurnIsTakenTheShortWayRound) {
  const Edge across{{0, 0, M_PI - 0.01}}, beside{{0, 0, 0.01}};
  EXPECT_NEAR(across.cost({}, {0, 0, -M_PI + 0.01}), beside.cost({}, {0, 0, -0.01}), kExactCost);
}

TEST(LinkTerm, aSlackRunGivesWayMoreCheaply) {
  const PoseGraph graph = test::drawnPoseGraph({{{}, {1, 0, 0}}});
  const PoseEdge& link = graph.edges[PoseEdgeId(0)];
  const Transform2D off{1.2, 0, 0.05};
  const double stiff = costOf(linkTerm(link, 0.5), link.measured, off);
  const double ordinary = costOf(linkTerm(link, 1), link.measured, off);
  EXPECT_GT(stiff, ordinary);
  EXPECT_NEAR(costOf(linkTerm(link, 1), link.measured, {1, 0, 0}), 0, kExactCost);
}

TEST(LinkTerm, countsAsFarAsItHolds) {
  const PoseGraph graph = test::drawnPoseGraph({{{}, {1, 0, 0}}});
  PoseEdge link = graph.edges[PoseEdgeId(0)];
  const Transform2D off{1.2, 0, 0.05};
  const double full = costOf(linkTerm(link, 1), link.measured, off);
  link.share = 0.5;
  EXPECT_NEAR(costOf(linkTerm(link, 1), link.measured, off), 0.5 * full, kExactCost);
}

TEST(MatchTerm, countsAsFarAsItIsBelievedAndItsWallsWereFound) {
  const Transform2D off{0.2, 0.1, 0.02};
  PoseEdge match = matchEdge(NodeId(0), NodeId(1), {}, 0.8);
  const double full = costOf(matchTerm(match, 1), {}, off);
  EXPECT_NEAR(costOf(matchTerm(match, 0.25), {}, off), 0.25 * full, kExactCost);
  match.share = 0.4;
  EXPECT_NEAR(costOf(matchTerm(match, 1), {}, off), 0.5 * full, kExactCost);
  EXPECT_EQ(costOf(matchTerm(match, 0), {}, off), 0);
}

TEST(MatchTerm, oneScanOfBothRunsHoldsThemCloser) {
  const Transform2D off{0.1, 0, 0};
  const PoseEdge found = matchEdge(NodeId(0), NodeId(1), {}, 1);
  const PoseEdge same = sameScanEdge(NodeId(0), NodeId(1));
  EXPECT_GT(costOf(matchTerm(same, 1), {}, off), 2 * costOf(matchTerm(found, 1), {}, off));
}

TEST(TermOf, anEdgeIsTrustedAsItsRunOrItsGroup) {
  PoseGraph graph = test::drawnPoseGraph({{{}, {1, 0, 0}}, {{}, {1, 0, 0}}});
  graph.addGroup({RunId(0), RunId(1), {}}, {matchEdge(NodeId(0), NodeId(2), {}, 1)});
  GraphTrust trust{ById<RunId, double>(2, 1), ById<MatchGroupId, double>(1, 0.5)};
  trust.slack[RunId(1)] = 0.5;
  const auto at = [&](std::size_t edge) {
    return termOf(graph, graph.edges[PoseEdgeId(edge)], trust);
  };
  EXPECT_EQ(at(1).noise.place, 0.5 * at(0).noise.place);
  EXPECT_EQ(at(2).weight, matchTerm(graph.edges[PoseEdgeId(2)], 0.5).weight);
}

}  // namespace
}  // namespace roomgraph
