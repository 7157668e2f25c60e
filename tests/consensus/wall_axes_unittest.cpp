#include "wall_axes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "roomgraph/consensus/solve_pose_graph.h"

namespace roomgraph {
namespace {

/** A drive along a line, whose walls are turned by `turnAt` of its nodes' numbers [rad]. */
template <class Turn>
PoseGraph driveAlong(std::size_t count, const Turn& turnAt) {
  PoseGraph graph;
  graph.addRun(true);
  for (std::size_t k = 0; k < count; ++k) {
    const NodeId node = graph.addNode({0.7 * double(k), 0, 0}, {}, ScanAxes{turnAt(k), 1});
    if (k > 0) graph.addLink(NodeId(node.index() - 1), node);
  }
  return graph;
}

double wingOf(std::size_t k) { return k >= 30 && k < 50 ? 0.14 : 0; }

std::optional<std::size_t> pairOf(const WallAxes& axes, std::size_t node) {
  return axes.ofNode[NodeId(node)];
}

/** How far the solution turns any node against where the graph has it [rad]. */
double turnedMost(const PoseGraph& graph) {
  const GraphTrust trust{ById<RunId, double>(1, 1), {}};
  const NodePoses start = graph.ownPoses();
  const NodePoses found = solvePoseGraph(graph, trust, start, StartIs::rough).poses;
  double most = 0;
  for (const NodeId node : start.ids())
    most = std::max(most, std::abs(wrappedAngle(found[node].phi - start[node].phi)));
  return most;
}

TEST(WallAxes, aWingAtAnotherAngleHasItsOwn) {
  const PoseGraph graph = driveAlong(80, wingOf);
  const WallAxes axes = wallAxes(graph, graph.ownPoses());
  EXPECT_EQ(axes.count, 2U);
  for (const std::size_t node : {0, 15, 24, 56, 79}) EXPECT_EQ(pairOf(axes, node), 0U) << node;
  for (const std::size_t node : {36, 40, 44}) EXPECT_EQ(pairOf(axes, node), 1U) << node;
  EXPECT_FALSE(pairOf(axes, 30)) << "the walls turn there";
  EXPECT_LT(turnedMost(graph), 1e-3);
}

TEST(WallAxes, aScanOrTwoThatAreTurnedAreNoWing) {
  const auto aFew = [](std::size_t k) { return k == 20 || k == 21 || k == 45 ? 0.14 : 0.0; };
  const PoseGraph graph = driveAlong(80, aFew);
  EXPECT_EQ(wallAxes(graph, graph.ownPoses()).count, 1U);
  EXPECT_EQ(pairOf(wallAxes(graph, graph.ownPoses()), 20), 0U);
}

TEST(WallAxes, aDriftIsNoWing) {
  for (const double each : {0.002, 0.05}) {
    const PoseGraph graph = driveAlong(80, [&](std::size_t k) { return each * double(k); });
    EXPECT_EQ(wallAxes(graph, graph.ownPoses()).count, 1U) << each;
  }
  EXPECT_GT(turnedMost(driveAlong(80, [](std::size_t k) { return 0.002 * double(k); })), 0.02);
}

TEST(WallAxes, aStepThatItsScansDoNotAgreeWithLeadsIntoNoWing) {
  PoseGraph graph = driveAlong(80, wingOf);
  graph.nodes[NodeId(30)].isDoubtful = graph.nodes[NodeId(50)].isDoubtful = true;
  EXPECT_EQ(wallAxes(graph, graph.ownPoses()).count, 1U);
}

TEST(WallAxes, quarterTurnsChangeNothing) {
  const PoseGraph graph =
      driveAlong(80, [](std::size_t k) { return axesAngle(wingOf(k) + M_PI / 2 * double(k % 4)); });
  EXPECT_EQ(wallAxes(graph, graph.ownPoses()).count, 2U);
}

TEST(WallAxes, withoutWallsThereAreNone) {
  PoseGraph graph;
  graph.addRun(true);
  graph.addNode({}, {}, std::nullopt);
  EXPECT_FALSE(pairOf(wallAxes(graph, graph.ownPoses()), 0));
}

}  // namespace
}  // namespace roomgraph
