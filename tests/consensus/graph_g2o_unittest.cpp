#include <gtest/gtest.h>

#include <sstream>

#include "roomgraph/consensus/Consensus.h"

namespace roomgraph {
namespace {

/** Two key frames a metre apart, and one of another run that was found in the first. */
Consensus threeNodes(double off) {
  Consensus consensus;
  PoseGraph& graph = consensus.graph;
  graph.addRun(true);
  const NodeId a = graph.addNode({}, {}, {}), b = graph.addNode({1, 0, 0}, {}, {});
  graph.addLink(a, b);
  graph.addRun(true);
  const NodeId c = graph.addNode({5, 0, 0}, {}, {});
  PoseEdge match;
  match.from = a, match.to = c, match.measured = {2, 0, 0}, match.noise = {0.1, 0.02};
  MatchGroup group;
  group.from = graph.runOf(a), group.to = graph.runOf(c);
  graph.addGroup(group, {match});
  consensus.trust.slack = ById<RunId, double>(2, 1);
  consensus.trust.belief = ById<MatchGroupId, double>(1, 1);
  consensus.poses = NodePoses(std::vector<Transform2D>{{}, {1, 0, 0}, {2 + off, 0, 0}});
  return consensus;
}

/** The information of x of the last edge. */
double informationOfMatch(const Consensus& consensus) {
  const std::string text = graphG2o(consensus);
  std::istringstream last(text.substr(text.rfind("EDGE_SE2")));
  std::string word;
  for (int i = 0; i < 6; ++i) last >> word;
  double information = 0;
  last >> information;
  return information;
}

TEST(GraphG2o, hasNodesWhereTheyLieAndEdgesAsMeasured) {
  const std::string text = graphG2o(threeNodes(0));
  EXPECT_EQ(text.find("VERTEX_SE2 0 0.000000 0.000000 0.000000000\nVERTEX_SE2 1 1.000000"), 0u);
  EXPECT_NE(text.find("\nFIX 0\nEDGE_SE2 0 1 1.000000 0.000000 0.000000000 "), std::string::npos);
  EXPECT_NE(text.find("\nEDGE_SE2 0 2 2.000000 0.000000 0.000000000 "), std::string::npos);
}

TEST(GraphG2o, whatContradictsTheRestCountsLittle) {
  EXPECT_GT(informationOfMatch(threeNodes(0)), 1);
  EXPECT_LT(informationOfMatch(threeNodes(5)), 0.01 * informationOfMatch(threeNodes(0)));
}

}  // namespace
}  // namespace roomgraph
