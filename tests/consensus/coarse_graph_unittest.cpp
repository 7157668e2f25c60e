#include "coarse_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_pose_graph.h"

namespace roomgraph {
namespace {

using test::roundTheBlock;
using test::Way;

/** Two runs in frames of their own, and what they find of each other. */
struct CoarseRuns {
  std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3)};
  PoseGraph graph = test::matchedPoseGraph({truth[0], test::moved(truth[1], {7, -3, 2})}, truth);
  NodePoses poses = test::posesOf(truth);
};

double farthest(const NodePoses& l, const NodePoses& r) {
  double most = 0;
  for (const NodeId node : l.ids())
    most = std::max({most, distance(l[node].shift(), r[node].shift()),
                     std::abs(wrappedAngle(l[node].phi - r[node].phi))});
  return most;
}

TEST(CoarseGraph, hasAboutAQuarterOfTheNodes) {
  const CoarseRuns two;
  const CoarseGraph coarse = coarseGraph(two.graph);
  for (const RunId run : two.graph.runs.ids()) {
    const std::size_t all = two.graph.runs[run].nodes.size();
    const std::size_t few = coarse.graph.runs[run].nodes.size();
    EXPECT_GE(4 * few, all);
    EXPECT_LE(4 * few, all + 12);
    EXPECT_EQ(coarse.graph.runs[run].links.size(), few - 1);
  }
}

TEST(CoarseGraph, whatHoldsOfAllHoldsOfTheCoarseOnes) {
  const CoarseRuns two;
  const CoarseGraph coarse = coarseGraph(two.graph);
  const NodePoses poses = coarsePoses(coarse, two.poses);
  ASSERT_EQ(coarse.graph.groups.size(), two.graph.groups.size());
  std::size_t matches = 0;
  for (const PoseEdge& edge : coarse.graph.edges) {
    if (!edge.group) continue;
    const Transform2D there = poses[edge.from] * edge.measured;
    EXPECT_LT(distance(there.shift(), poses[edge.to].shift()), 1e-9);
    ++matches;
  }
  EXPECT_GT(matches, 50u);
}

TEST(CoarseGraph, allNodesGoWhereTheirCoarseOnesGo) {
  const CoarseRuns two;
  const CoarseGraph coarse = coarseGraph(two.graph);
  EXPECT_LT(farthest(finePoses(coarse, two.poses, coarsePoses(coarse, two.poses)), two.poses),
            1e-9);
  NodePoses moved = two.poses;
  for (const NodeId node : two.graph.runs[RunId(1)].nodes)
    moved[node] = Transform2D{3, -8, 1} * moved[node];
  EXPECT_LT(farthest(finePoses(coarse, two.poses, coarsePoses(coarse, moved)), moved), 1e-9);
}

TEST(CoarseGraph, nothingIsJoinedAcrossTheEndOfAGroup) {
  const CoarseRuns two;
  const NodeId last = two.graph.runs[RunId(0)].nodes[20], next = two.graph.runs[RunId(0)].nodes[21];
  const CoarseGraph coarse = coarseGraph(
      test::withMatches(two.graph, [&](const MatchGroup& group, const PoseEdge& edge, std::size_t) {
        return group.to == RunId(1) || edge.to < next;
      }));
  EXPECT_NE(coarse.coarseOf[last], coarse.coarseOf[next]);
}

TEST(CoarseGraph, patchesStayAsTheyAre) {
  CoarseRuns two;
  two.graph.runs[RunId(1)].hasScans = false;
  const CoarseGraph coarse = coarseGraph(two.graph);
  EXPECT_EQ(coarse.graph.runs[RunId(1)].nodes.size(), two.graph.runs[RunId(1)].nodes.size());
  EXPECT_LT(coarse.graph.runs[RunId(0)].nodes.size(), two.graph.runs[RunId(0)].nodes.size());
}

TEST(CoarseGraph, aRunIsFoundInItselfAsWell) {
  const Way once = roundTheBlock();
  Way twice = once;
  twice.insert(twice.end(), once.begin(), once.end());
  PoseGraph graph = test::drawnPoseGraph({twice});
  std::vector<PoseEdge> matches;
  for (std::size_t k = 0; k < once.size(); ++k)
    matches.push_back(matchEdge(NodeId(k), NodeId(once.size() + k), {}, 1));
  graph.addGroup({RunId(0), RunId(0), {}}, matches);
  const CoarseGraph coarse = coarseGraph(graph);
  EXPECT_LT(coarse.graph.nodes.size(), graph.nodes.size() / 3);
  const NodePoses poses = test::posesOf({twice});
  EXPECT_LT(farthest(finePoses(coarse, poses, coarsePoses(coarse, poses)), poses), 1e-9);
}

TEST(CoarseGraph, ofNothingIsNothing) {
  PoseGraph graph;
  graph.addRun(true), graph.addRun(true);
  const CoarseGraph coarse = coarseGraph(graph);
  EXPECT_EQ(coarse.graph.runs.size(), 2u);
  EXPECT_EQ(finePoses(coarse, {}, {}).size(), 0u);
}

}  // namespace
}  // namespace roomgraph
