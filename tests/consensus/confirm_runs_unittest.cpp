#include "confirm_runs.h"

#include <gtest/gtest.h>

#include "drawn_pose_graph.h"

namespace roomgraph {
namespace {

const test::Way& way() {
  static const test::Way the = test::roundTheBlock();
  return the;
}

ById<MatchGroupId, double> allBelieved(const PoseGraph& graph) {
  return ById<MatchGroupId, double>(graph.groups.size(), 1.0);
}

std::size_t countOf(const ById<NodeId, bool>& isConfirmed) {
  std::size_t count = 0;
  for (const bool one : isConfirmed) count += one;
  return count;
}

TEST(ConfirmedNodes, areThoseThatOthersFoundWhereTheyLie) {
  const PoseGraph graph = test::matchedPoseGraph({way(), way()}, {way(), way()});
  EXPECT_EQ(countOf(confirmedNodes(graph, graph.ownPoses(), allBelieved(graph))),
            graph.nodes.size());
}

TEST(ConfirmedNodes, aGroupThatIsNotBelievedConfirmsNothing) {
  const PoseGraph graph = test::matchedPoseGraph({way(), way()}, {way(), way()});
  const ById<MatchGroupId, double> doubted(graph.groups.size(), 0.2);
  EXPECT_EQ(countOf(confirmedNodes(graph, graph.ownPoses(), doubted)), 0u);
}

TEST(ConfirmedNodes, whatAMatchHasElsewhereItDoesNotConfirm) {
  const PoseGraph graph = test::matchedPoseGraph({way(), way()}, {way(), way()});
  NodePoses poses = graph.ownPoses();
  const NodeId moved = graph.runs[RunId(1)].nodes[7];
  poses[moved].x += 3;
  const auto isConfirmed = confirmedNodes(graph, poses, allBelieved(graph));
  EXPECT_FALSE(isConfirmed[moved]);
  EXPECT_TRUE(isConfirmed[graph.runs[RunId(1)].nodes[8]]);
}

TEST(Gaps, areTheStretchesBetweenWhatWasFound) {
  const auto gaps = gapsOf({false, true, false, false, true, true, false});
  ASSERT_EQ(gaps.size(), 3u);
  EXPECT_EQ(gaps[0].size(), 1u);
  EXPECT_EQ(gaps[1].first, 2u);
  EXPECT_EQ(gaps[1].end, 4u);
  EXPECT_EQ(gaps[2].end, 7u);
  EXPECT_TRUE(gapsOf({}).empty());
  EXPECT_TRUE(gapsOf({true, true}).empty());
}

TEST(Gaps, areLongByTheirScansOrTheirWay) {
  std::vector<ScanWalls> scans(40);
  for (std::size_t k = 0; k < scans.size(); ++k) scans[k].pose.x = double(k);
  EXPECT_TRUE(isLong({10, 19}, scans)) << "8 m from the first to the last";
  EXPECT_FALSE(isLong({10, 18}, scans));
  scans[9].pose.x = -100;
  EXPECT_FALSE(isLong({10, 18}, scans)) << "the break before it is no part of it";
  for (ScanWalls& scan : scans) scan.pose.x /= 100;
  EXPECT_TRUE(isLong({10, 22}, scans));
  EXPECT_FALSE(isLong({10, 21}, scans));
}

}  // namespace
}  // namespace roomgraph
