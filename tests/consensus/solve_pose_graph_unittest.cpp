#include "roomgraph/consensus/solve_pose_graph.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_pose_graph.h"
#include "edge_cost.h"
#include "start_poses.h"

namespace roomgraph {
namespace {

using test::posesOf;
using test::roundTheBlock;
using test::Way;

/** All runs are ordinary, and all groups are believed. */
GraphTrust fullTrust(const PoseGraph& graph) {
  return {ById<RunId, double>(graph.runs.size(), 1),
          ById<MatchGroupId, double>(graph.groups.size(), 1)};
}

PoseGraphSolution solve(const PoseGraph& graph, const NodePoses& start,
                        StartIs startIs = StartIs::rough) {
  return solvePoseGraph(graph, fullTrust(graph), start, startIs);
}

TEST(SolvePoseGraph, whatFitsStaysAsItIs) {
  const std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3)};
  for (const StartIs start : {StartIs::rough, StartIs::good}) {
    const auto found = solve(test::matchedPoseGraph(truth, truth), posesOf(truth), start);
    EXPECT_LT(found.cost, 1e-9);
    EXPECT_LT(test::misplaced(found.poses, truth), 1e-6);
  }
}

TEST(SolvePoseGraph, aRoughStartIsMended) {
  const std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3), roundTheBlock(0.6)};
  const NodePoses start =
      posesOf({truth[0], test::drifting(truth[1], 0.01), test::moved(truth[2], {0.5, -0.3, 0.1})});
  const auto found = solve(test::matchedPoseGraph(truth, truth), start);
  EXPECT_LT(test::misplaced(found.poses, truth), 0.02);
}

TEST(SolvePoseGraph, theLinksOfARunHaveTheScaleOfTheOthers) {
  const std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3), roundTheBlock(0.6)};
  for (const double scale : {0.9, 1.02, 1.05}) {
    const PoseGraph graph =
        test::matchedPoseGraph({truth[0], test::scaled(truth[1], scale), truth[2]}, truth);
    const auto found = solve(graph, graph.ownPoses());
    EXPECT_NEAR(found.stretches[RunId(0)], 1, 0.002);
    EXPECT_NEAR(found.stretches[RunId(1)], 1 / scale, 0.003);
    EXPECT_LT(test::misplaced(found.poses, truth), 0.02);
  }
}

TEST(SolvePoseGraph, scalesGoOnFromThoseThatTheLinksHave) {
  const std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3), roundTheBlock(0.6)};
  PoseGraph graph =
      test::matchedPoseGraph({truth[0], test::scaled(truth[1], 1.05), truth[2]}, truth);
  const auto first = solve(graph, graph.ownPoses());
  for (const RunId run : graph.runs.ids()) graph.setStretch(run, first.stretches[run]);
  const auto second = solve(graph, first.poses, StartIs::good);
  for (const RunId run : graph.runs.ids())
    EXPECT_NEAR(second.stretches[run], first.stretches[run], 1e-4);
}

TEST(SolvePoseGraph, ofTwoRunsNoScaleShowsButAgainstAReference) {
  const std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3)};
  PoseGraph graph = test::matchedPoseGraph({truth[0], test::scaled(truth[1], 1.05)}, truth);
  EXPECT_EQ(solve(graph, graph.ownPoses()).stretches[RunId(1)], 1);
  graph.reference = RunId(0);
  EXPECT_NEAR(solve(graph, graph.ownPoses()).stretches[RunId(1)], 1 / 1.05, 0.002);
}

TEST(SolvePoseGraph, theReferenceDoesNotMove) {
  const Way way = roundTheBlock(), bent = test::drifting(way, 0.01);
  PoseGraph graph = test::matchedPoseGraph({way, bent}, {way, way});
  graph.reference = RunId(1);
  const auto found = solve(graph, startPoses(graph, RunId(1)));
  const Way stays = test::wayOf(graph, found.poses, 1);
  for (std::size_t k = 0; k < bent.size(); ++k) {
    EXPECT_EQ(stays[k].x, bent[k].x);
    EXPECT_EQ(stays[k].y, bent[k].y);
    EXPECT_NEAR(wrappedAngle(stays[k].phi - bent[k].phi), 0, 1e-12);
  }
  EXPECT_LT(test::displacement(test::wayOf(graph, found.poses, 0), bent),
            0.5 * test::displacement(way, bent));
}

TEST(SolvePoseGraph, itsAxesStraightenALonelyRun) {
  const Way way = roundTheBlock(), bent = test::drifting(way, 0.004);
  PoseGraph graph = test::drawnPoseGraph({bent});
  for (const NodeId node : graph.nodes.ids())
    graph.nodes[node].axes = ScanAxes{-way[node.index()].phi, 1};
  const auto found = solve(graph, posesOf({bent}));
  EXPECT_LT(test::displacement(test::wayOf(graph, found.poses, 0), way),
            0.3 * test::displacement(bent, way));
  for (PoseNode& node : graph.nodes) node.axes.reset();
  const auto without = solve(graph, posesOf({bent}));
  EXPECT_LT(test::displacement(test::wayOf(graph, without.poses, 0), bent), 1e-9);
}

/** Half the robust squared residual of all edges, term by term. */
double costOf(const PoseGraph& graph, const NodePoses& poses) {
  const GraphTrust trust = fullTrust(graph);
  double cost = 0;
  for (const PoseEdge& edge : graph.edges)
    cost += termOf(graph, edge, trust).cost(gapOf(edge, poses));
  return cost;
}

/** A sound run, and one that drifts. */
struct Drifting {
  Way truth = roundTheBlock(), bent = test::drifting(truth, 0.004);
  PoseGraph graph = test::matchedPoseGraph({truth, bent}, {truth, truth});
  NodePoses start = posesOf({truth, bent});
};

TEST(SolvePoseGraph, itsCostIsThatOfItsTerms) {
  const Drifting drift;
  for (const StartIs startIs : {StartIs::rough, StartIs::good}) {
    const auto found = solve(drift.graph, drift.start, startIs);
    ASSERT_GT(found.cost, 0.1);
    EXPECT_NEAR(found.cost, costOf(drift.graph, found.poses), 1e-6 * found.cost);
  }
}

TEST(SolvePoseGraph, noPoseCanMoveAloneAndMakeItCheaper) {
  const Drifting drift;
  const auto found = solve(drift.graph, drift.start);
  for (const std::size_t k : {5u, 20u, 41u})
    for (const Transform2D& nudge : {Transform2D{0.01, 0, 0}, Transform2D{0, -0.01, 0},
                                     Transform2D{0, 0, 0.003}, Transform2D{-0.01, 0.01, -0.003}}) {
      NodePoses poses = found.poses;
      const NodeId node = drift.graph.runs[RunId(1)].nodes[k];
      poses[node] = poses[node] * nudge;
      EXPECT_GT(costOf(drift.graph, poses), found.cost) << k;
    }
}

TEST(SolvePoseGraph, theFrameOfTheStartIsThatOfTheSolution) {
  const Drifting drift;
  const auto here = solve(drift.graph, drift.start);
  const Transform2D motion{30, -7, 2};
  const auto there = solve(
      drift.graph, posesOf({test::moved(drift.truth, motion), test::moved(drift.bent, motion)}));
  EXPECT_NEAR(there.cost, here.cost, 1e-3 * here.cost);
  for (const NodeId node : here.poses.ids())
    EXPECT_LT(distance((motion * here.poses[node]).shift(), there.poses[node].shift()), 0.002);
}

TEST(SolvePoseGraph, aRunWithMoreSlackBendsMore) {
  const Drifting drift;
  const auto restOf = [&](double slack) {
    GraphTrust trust = fullTrust(drift.graph);
    trust.slack[RunId(0)] = 0.1, trust.slack[RunId(1)] = slack;
    const auto found = solvePoseGraph(drift.graph, trust, drift.start, StartIs::rough);
    return test::displacement(test::wayOf(drift.graph, found.poses, 1), drift.truth);
  };
  EXPECT_LT(restOf(1), restOf(0.2));
  EXPECT_LT(restOf(0.2), test::displacement(drift.bent, drift.truth));
}

TEST(SolvePoseGraph, aGroupThatIsGivenUpTakesNoPart) {
  const Drifting drift;
  const auto alone = solve(drift.graph, drift.start, StartIs::good);
  PoseGraph graph = drift.graph;
  const MatchGroup first = graph.groups[MatchGroupId(0)];
  std::vector<PoseEdge> wrong;
  for (const PoseEdgeId id : first.edges) {
    wrong.push_back(graph.edges[id]);
    wrong.back().measured = Transform2D{3, 0, 1} * wrong.back().measured;
  }
  graph.addGroup(first, wrong);
  GraphTrust trust = fullTrust(graph);
  trust.belief[MatchGroupId(2)] = beliefOf(0);
  const auto with = solvePoseGraph(graph, trust, drift.start, StartIs::good);
  EXPECT_EQ(with.cost, alone.cost);
  EXPECT_EQ(test::misplaced(with.poses, {Way(alone.poses.begin(), alone.poses.end())}), 0);
}

TEST(SolvePoseGraph, oneRunIsClosedByWhatWasFoundOfItInItself) {
  Way truth = roundTheBlock();
  const Way again = roundTheBlock();
  truth.insert(truth.end(), again.begin(), again.end());
  const Way bent = test::drifting(truth, 0.002);
  PoseGraph graph = test::drawnPoseGraph({bent});
  std::vector<PoseEdge> matches;
  for (std::size_t k = 0; k < again.size(); ++k)
    matches.push_back(matchEdge(NodeId(k), NodeId(again.size() + k), {}, 1));
  matches.push_back(matchEdge(NodeId(3), NodeId(3), {}, 1));  // says nothing
  graph.addGroup({RunId(0), RunId(0), {}}, matches);
  const auto found = solve(graph, posesOf({bent}));
  for (std::size_t k = 0; k < again.size(); ++k)
    EXPECT_LT(
        distance(found.poses[NodeId(k)].shift(), found.poses[NodeId(again.size() + k)].shift()),
        0.3)
        << k;
}

TEST(SolvePoseGraph, runsThatNothingJoinsKeepTheirShape) {
  const Way way = roundTheBlock(), torn = test::torn(way, 20, 1, {2, 3});
  const PoseGraph graph = test::drawnPoseGraph({way, torn, {}});
  const auto found = solve(graph, posesOf({way, torn, {}}));
  EXPECT_NEAR(found.cost, 0, 1e-9);
  EXPECT_LT(test::misplaced(test::wayOf(graph, found.poses, 1), torn), 1e-6);
}

TEST(SolvePoseGraph, axesMayLieByAQuarterTurn) {
  const Way way = roundTheBlock();
  PoseGraph graph = test::drawnPoseGraph({way});
  for (const NodeId node : graph.nodes.ids())
    graph.nodes[node].axes =
        ScanAxes{-way[node.index()].phi + double(node.index() % 4) * M_PI / 2, 1};
  const auto found = solve(graph, posesOf({way}));
  EXPECT_LT(found.cost, 1e-9);
  EXPECT_LT(test::displacement(test::wayOf(graph, found.poses, 0), way), 1e-6);
}

}  // namespace
}  // namespace roomgraph
