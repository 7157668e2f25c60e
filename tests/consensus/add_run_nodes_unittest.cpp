#include <gtest/gtest.h>

#include "roomgraph/consensus/PoseGraph.h"
#include "sample_runs.h"

namespace roomgraph {
namespace {

PoseGraph graphOf(const roomgraph::Run& run) {
  PoseGraph graph;
  addRunNodes(run, graph);
  return graph;
}

TEST(AddRunNodes, aScanIsOneAndIsLinkedToTheNext) {
  const roomgraph::Run run = test::drivenRun();
  const PoseGraph graph = graphOf(run);
  EXPECT_TRUE(graph.runs[RunId(0)].hasScans);
  ASSERT_EQ(graph.nodes.size(), run.scans.size());
  ASSERT_EQ(graph.edges.size(), run.scans.size() - 1);
  for (std::size_t k = 0; k < run.scans.size(); ++k) {
    const PoseNode& node = graph.nodes[NodeId(k)];
    EXPECT_EQ(node.pose.shift(), run.scans[k].robot());
    EXPECT_EQ(node.points.count, run.scans[k].ends.count);
    EXPECT_EQ(node.points.xx, run.scans[k].ends.xx);
    EXPECT_EQ(node.axes.has_value(), run.scans[k].axes.has_value());
    if (k == 0) continue;
    EXPECT_EQ(graph.edges[PoseEdgeId(k - 1)].from, NodeId(k - 1));
    EXPECT_EQ(graph.edges[PoseEdgeId(k - 1)].to, NodeId(k));
  }
}

TEST(AddRunNodes, withoutScansAPatchIsOne) {
  const roomgraph::Run run = test::scanlessRun();
  const PoseGraph graph = graphOf(run);
  EXPECT_FALSE(graph.runs[RunId(0)].hasScans);
  ASSERT_EQ(graph.nodes.size(), run.map.patches.size());
  for (std::size_t k = 0; k < graph.nodes.size(); ++k) {
    const PoseNode& node = graph.nodes[NodeId(k)];
    EXPECT_EQ(node.pose.shift(), run.map.patches[k].middle);
    EXPECT_EQ(node.points.count, double(run.map.patches[k].own.size()));
    EXPECT_NEAR(node.points.x, 0, 1e-6) << "its middle is the mean of its walls";
    EXPECT_FALSE(node.axes);
  }
}

TEST(AddRunNodes, neighbouringPatchesAreLinkedOnce) {
  const roomgraph::Run run = test::scanlessRun();
  std::size_t sides = 0;
  for (const WallPatch& patch : run.map.patches) sides += patch.neighbours.size();
  const PoseGraph graph = graphOf(run);
  EXPECT_EQ(2 * graph.edges.size(), sides);
  for (const PoseEdge& link : graph.edges) EXPECT_LT(link.from, link.to);
}

TEST(AddRunNodes, aSecondRunComesBehindTheFirst) {
  PoseGraph graph;
  const roomgraph::Run driven = test::drivenRun(), flat = test::scanlessRun();
  const RunId first = addRunNodes(driven, graph), second = addRunNodes(flat, graph);
  EXPECT_EQ(graph.runs[first].nodes.size(), driven.scans.size());
  EXPECT_EQ(graph.runs[second].nodes.front(), NodeId(driven.scans.size()));
  for (const PoseEdgeId link : graph.runs[second].links) {
    EXPECT_EQ(graph.runOf(graph.edges[link].from), second);
    EXPECT_EQ(graph.runOf(graph.edges[link].to), second);
  }
}

TEST(AddRunNodes, ofNothingThereAreNone) {
  const PoseGraph graph = graphOf({});
  EXPECT_EQ(graph.nodes.size(), 0u);
  EXPECT_EQ(graph.edges.size(), 0u);
}

}  // namespace
}  // namespace roomgraph
