#include "roomgraph/consensus/pose_covariances.h"

#include <gtest/gtest.h>

#include <cmath>

#include "edge_cost.h"

namespace roomgraph {
namespace {

/** A run of key frames a metre apart in a direction, as it was driven. */
struct Drive {
  PoseGraph graph;
  GraphTrust trust;
  NodePoses poses;

  explicit Drive(std::size_t size, double heading = 0) {
    graph.addRun(true);
    for (std::size_t k = 0; k < size; ++k) {
      const auto along = double(k);
      const NodeId node =
          graph.addNode({along * std::cos(heading), along * std::sin(heading), heading}, {}, {});
      if (k > 0) graph.addLink(NodeId(k - 1), node);
    }
    trust.slack = ById<RunId, double>(1, 1.0);
    poses = graph.ownPoses();
  }

  /** The last key frame is found beside the first, where it lies. */
  void close() {
    const NodeId first(0), last(graph.nodes.size() - 1);
    graph.addGroup({RunId(0), RunId(0), {}},
                   {matchEdge(first, last, poses[first].inverse() * poses[last], 1)});
    trust.belief = ById<MatchGroupId, double>(1, 1.0);
  }

  std::vector<PlanarCovariance> covariances() const {
    return poseCovariances(graph, trust, poses, {RunId(0)}).front();
  }
};

TEST(PoseCovariances, twoKeyFramesAreOffByHalfOfTheirLinkEach) {
  const Drive drive(2);
  const double place = linkTerm(drive.graph.edges[PoseEdgeId(0)], 1).noise.place;
  for (const PlanarCovariance& sure : drive.covariances()) {
    EXPECT_NEAR(sure.xx, place * place / 4, 1e-9);
    EXPECT_NEAR(sure.yy, 0, 1e-9);  // which the turn of the run as a whole takes up
    EXPECT_NEAR(sure.xy, 0, 1e-9);
    EXPECT_GT(sure.pp, 0);
  }
}

TEST(PoseCovariances, endsAreLessSureThanTheMiddle) {
  const std::vector<PlanarCovariance> sure = Drive(41).covariances();
  EXPECT_LT(1.5 * sure[20].yy, sure[0].yy);
  EXPECT_NEAR(sure[0].yy, sure[40].yy, 0.01 * sure[0].yy);
}

TEST(PoseCovariances, axesTurnWithTheFrame) {
  const PlanarCovariance along = Drive(30).covariances().front();
  const PlanarCovariance across = Drive(30, std::acos(-1) / 2).covariances().front();
  EXPECT_NEAR(along.xx, across.yy, 1e-6 * along.xx);
  EXPECT_NEAR(along.yy, across.xx, 1e-6 * along.yy);
  EXPECT_NEAR(along.yp, -across.xp, 1e-6 * std::abs(along.yp));
}

TEST(PoseCovariances, whatIsSeenAgainIsSurer) {
  Drive drive(41);
  const double open = drive.covariances().front().yy;
  drive.close();
  EXPECT_LT(drive.covariances().front().yy, 0.5 * open);
}

TEST(PoseCovariances, whatContradictsTheRestSaysNothing) {
  Drive drive(41);
  const double open = drive.covariances().front().yy;
  drive.close();
  drive.graph.edges[PoseEdgeId(drive.graph.edges.size() - 1)].measured.y += 30;
  EXPECT_NEAR(drive.covariances().front().yy, open, 0.05 * open);
}

TEST(PoseCovariances, ofManyKeyFramesSomeAreInterpolated) {
  const std::vector<PlanarCovariance> few = Drive(61).covariances(),
                                      many = Drive(122).covariances();
  ASSERT_EQ(many.size(), 122u);
  EXPECT_NEAR(few[30].pp, few[29].pp, 0.1 * few[30].pp);
  for (std::size_t k = 1; k < many.size(); ++k)
    EXPECT_LT(std::abs(many[k].yy - many[k - 1].yy), 0.1 * many.front().yy) << k;
}

TEST(PoseCovariances, aRunWithoutKeyFramesHasNone) {
  Drive drive(0);
  EXPECT_TRUE(drive.covariances().empty());
}

}  // namespace
}  // namespace roomgraph
