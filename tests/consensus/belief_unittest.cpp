#include "roomgraph/consensus/belief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_pose_graph.h"

namespace roomgraph {
namespace {

using test::roundTheBlock;
using test::Way;

/** Two runs, and one group. */
struct BelievedRuns {
  std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3)};
  PoseGraph graph = test::withMatches(
      test::matchedPoseGraph(truth, truth),
      [](const MatchGroup& group, const PoseEdge&, std::size_t) { return group.to == RunId(0); });

  /** Makes a share of the matches wrong by so much. */
  void shift(double by, double share = 1) {
    test::changeMatches(graph, [&](const MatchGroup& group, PoseEdge& edge, std::size_t place) {
      if (double(place) < share * double(group.edges.size())) edge.measured.x += by;
    });
  }
  double belief(const PoseTolerance& within = kInlier) const {
    return *beliefIn(graph, test::posesOf(truth), within).begin();
  }
};

TEST(Belief, isFullWhereThePosesAgreeWithAll) { EXPECT_EQ(BelievedRuns().belief(), 1); }

TEST(Belief, fallsFasterThanTheShareOfInliers) {
  BelievedRuns two;
  two.shift(20, 0.5);
  EXPECT_NEAR(two.belief(), 0.25, 0.02);
}

TEST(Belief, isNeverNothingSoThatAGroupCanComeBack) {
  BelievedRuns two;
  two.shift(20);
  EXPECT_GT(two.belief(), 0);
  EXPECT_LT(two.belief(), 0.01);
}

TEST(Belief, allowsMoreBeforeThePosesAreSolved) {
  BelievedRuns two;
  two.shift(2);
  EXPECT_LT(two.belief(kInlier), 0.01);
  EXPECT_EQ(two.belief(kRoughly), 1);
}

TEST(GivenUpBetween, isTheShareOfMatchesThatThePosesContradict) {
  BelievedRuns two;
  const auto givenUp = [&](RunId a, RunId b) {
    return givenUpBetween(two.graph, test::posesOf(two.truth), a, b);
  };
  EXPECT_EQ(givenUp(RunId(0), RunId(1)), 0);
  two.shift(20, 0.5);
  EXPECT_NEAR(givenUp(RunId(0), RunId(1)), 0.5, 0.02);
  EXPECT_EQ(givenUp(RunId(1), RunId(0)), givenUp(RunId(0), RunId(1)));
  EXPECT_EQ(givenUp(RunId(0), RunId(0)), 0);
}

TEST(Belief, isFullOfWhatBothHaveScannedAsOne) {
  BelievedRuns two;
  two.shift(20);
  test::changeMatches(
      two.graph, [](const MatchGroup&, PoseEdge& edge, std::size_t) { edge.isSameScan = true; });
  EXPECT_EQ(two.belief(), 1);
}

/** A group of so many matches. */
MatchGroup groupOf(std::size_t matches) { return {RunId(0), RunId(1), {0, matches}}; }

TEST(CostOfGivingUp, growsWithTheRootOfTheMatches) {
  EXPECT_NEAR(costOfGivingUp(groupOf(100)), 2 * costOfGivingUp(groupOf(25)), 1e-9);
}

TEST(CostOfDisbelief, isThatOfWhatIsNotBelieved) {
  const BelievedRuns two;
  const double full = costOfGivingUp(two.graph.groups[MatchGroupId(0)]);
  const auto believed = [](double belief) { return ById<MatchGroupId, double>(1, belief); };
  EXPECT_EQ(costOfDisbelief(two.graph, believed(1)), 0);
  EXPECT_NEAR(costOfDisbelief(two.graph, believed(0.25)), 0.75 * full, 1e-9);
}

TEST(IsInlier, whereThePosesAgreeWithinTheTolerance) {
  const PoseEdge match = matchEdge(NodeId(0), NodeId(1), {1, 2, 3}, 1);
  const auto isAt = [&](const Transform2D& found) {
    NodePoses poses;
    poses.add({}), poses.add(found);
    return isInlier(match, gapOf(match, poses), kInlier);
  };
  EXPECT_TRUE(isAt({1 + 0.9 * kInlier.place, 2, 3}));
  EXPECT_FALSE(isAt({1 + 1.1 * kInlier.place, 2, 3}));
  EXPECT_TRUE(isAt({1, 2, 3 + 0.9 * kInlier.turn - 2 * M_PI}));
  EXPECT_FALSE(isAt({1, 2, 3 - 1.1 * kInlier.turn}));
}

TEST(BeliefOf, growsWithTheShareFromLittleToAll) {
  EXPECT_EQ(beliefOf(1), 1);
  double last = 0;
  for (int i = 0; i <= 10; ++i) {
    const double belief = beliefOf(i / 10.0);
    EXPECT_GT(belief, 0);
    EXPECT_GE(belief, last);
    EXPECT_LE(belief, std::max(1e-3, i / 10.0)) << "a part counts less than its share";
    last = belief;
  }
}

using test::roundTheBlock;
using test::Way;

/** A straight way of 40 m. */
Way straight() {
  Way way;
  for (int k = 0; k < 40; ++k) way.push_back({double(k), 0, 0});
  return way;
}

/** The slack of one run that was drawn at the one way and lies at the other. */
double slackOf(const Way& drawn, const Way& truth) {
  return *runSlack(test::drawnPoseGraph({drawn}), test::posesOf({truth})).begin();
}

TEST(RunSlack, ofARunThatLiesAsItIsDrawnItIsTheLeast) {
  const Way way = roundTheBlock();
  const double least = slackOf(way, test::moved(way, {3, 4, 1}));
  EXPECT_GT(least, 0);
  EXPECT_LT(least, 0.2);
  EXPECT_EQ(slackOf({}, {}), least);
}

TEST(RunSlack, growsWithADriftAsItsStepsDoUpToOne) {
  const double once = slackOf(test::drifting(straight(), 0.002), straight());
  EXPECT_GT(once, slackOf(straight(), straight()));
  EXPECT_NEAR(slackOf(straight(), test::drifting(straight(), 0.004)),
              2 * slackOf(straight(), test::drifting(straight(), 0.002)), 1e-6);
  EXPECT_NEAR(slackOf(test::drifting(straight(), -0.002), straight()), once, 1e-9);
  EXPECT_EQ(slackOf(test::drifting(straight(), 0.5), straight()), 1);
}

TEST(RunSlack, ofADriftIsThatOfEachStep) {
  const double turn = 0.005;
  const PoseGraph graph = test::drawnPoseGraph({test::drifting(straight(), turn)});
  const double allowed = graph.edges[PoseEdgeId(0)].noise.turn;
  EXPECT_NEAR(*runSlack(graph, test::posesOf({straight()})).begin(), turn / allowed / std::sqrt(3),
              1e-9);
}

TEST(RunSlack, aTearDoesNotCount) {
  const Way way = roundTheBlock();
  EXPECT_EQ(slackOf(test::torn(way, 30, M_PI / 2, {3, 4}), way), slackOf(way, way));
}

TEST(RunSlack, runsOfOneDriveAreNotThatMuchTrusted) {
  const Way way = roundTheBlock();
  PoseGraph graph = test::matchedPoseGraph({way, way, way}, {way, way, way});
  test::changeMatches(graph, [](const MatchGroup& group, PoseEdge& edge, std::size_t) {
    edge.isSameScan = test::joins(group, 1, 2);
  });
  const auto slack = runSlack(graph, test::posesOf({way, way, way}));
  EXPECT_EQ(slack[RunId(1)], slack[RunId(2)]);
  EXPECT_GT(slack[RunId(1)], 2 * slack[RunId(0)]);
}

TEST(RunSlack, ofPatchesItCountsOnlyHowRunsCompare) {
  const Way way = straight();
  PoseGraph graph = test::drawnPoseGraph({way, way});
  for (GraphRun& run : graph.runs) run.hasScans = false;
  const auto slack =
      runSlack(graph, test::posesOf({test::drifting(way, 0.001), test::drifting(way, 0.0005)}));
  EXPECT_EQ(slack[RunId(0)], 1);
  EXPECT_NEAR(slack[RunId(1)], 0.5, 1e-3);
}

}  // namespace
}  // namespace roomgraph
