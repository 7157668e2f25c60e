#include "roomgraph/consensus/run_slack.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_pose_graph.h"

namespace roomgraph {
namespace {

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
