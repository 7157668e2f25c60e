#include "roomgraph/consensus/add_to_consensus.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_pose_graph.h"
#include "roomgraph/consensus/find_consensus.h"

namespace roomgraph {
namespace {

using test::roundTheBlock;
using test::Way;

const RunId kAdded(3);

/** Three sound runs where they really lie, and one that is torn and in a frame of its own. */
struct Block {
  std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3), roundTheBlock(0.6),
                         roundTheBlock(0.9)};
  Way drawn = test::moved(test::torn(truth[3], 30, M_PI / 2, {3, 4}), {0, 9, -1});
  PoseGraph graph = test::matchedPoseGraph({truth[0], truth[1], truth[2], drawn}, truth);
  NodePoses poses = test::posesOf({truth[0], truth[1], truth[2]});

  /** Those that join the added run and one of the first so many others. */
  std::vector<MatchGroupId> groups(std::size_t others) const {
    std::vector<MatchGroupId> own;
    for (const MatchGroupId id : graph.groups.ids())
      for (std::size_t other = 0; other < others; ++other)
        if (test::joins(graph.groups[id], kAdded.index(), other)) own.push_back(id);
    return own;
  }
  AddedToConsensus added(std::size_t others = 3) const {
    return addToConsensus(graph, kAdded, groups(others), poses);
  }
};

TEST(AddToConsensus, aRunIsPutWhereTheOthersSayThatItLies) {
  const Block block;
  const AddedToConsensus added = block.added();
  ASSERT_EQ(added.poses.size(), block.truth[3].size());
  for (std::size_t k = 0; k < added.poses.size(); ++k)
    EXPECT_LT(distance(added.poses[k].shift(), block.truth[3][k].shift()), 0.02) << k;
  const double really = test::displacement(block.drawn, block.truth[3]);
  ASSERT_GT(really, 0.3);
  EXPECT_NEAR(added.error.error, really, 0.05 * really);
  EXPECT_LT(added.error.low, really);
  EXPECT_GT(added.error.high, really);
  EXPECT_EQ(added.error.seen, 1);
  EXPECT_LE(added.slack, 1);
}

TEST(AddToConsensus, itIsWhatAllRunsTogetherComeTo) {
  const Block block;
  PoseGraph graph = block.graph;
  graph.reference = RunId(0);
  const MapError error = mapErrors(graph, findConsensus(graph).best)[kAdded];
  const AddedToConsensus added = block.added();
  EXPECT_NEAR(added.error.error, error.error, 0.01);
  EXPECT_NEAR(added.error.low, error.low, 0.01) << "as many runs have their say";
  EXPECT_NEAR(added.error.high, error.high, 0.01);
}

TEST(AddToConsensus, fewJudgesTellLess) {
  const Block block;
  const MapError many = block.added().error, few = block.added(1).error;
  EXPECT_GT(few.high - few.low, many.high - many.low);
}

TEST(AddToConsensus, aRunThatNobodyHasSeenKeepsItsShape) {
  const Block block;
  const AddedToConsensus added = block.added(0);
  EXPECT_LT(test::misplaced(added.poses, block.drawn), 1e-6);
  EXPECT_EQ(added.error.seen, 0);
}

TEST(AddToConsensus, matchesOfOthersHaveNoSay) {
  Block block;
  const AddedToConsensus before = block.added();
  test::changeMatches(block.graph, [](const MatchGroup& group, PoseEdge& edge, std::size_t) {
    if (group.from != kAdded && group.to != kAdded) edge.measured.x += 4;
  });
  const AddedToConsensus after = block.added();
  EXPECT_EQ(after.error.error, before.error.error);
  EXPECT_EQ(after.error.high, before.error.high);
  for (std::size_t k = 0; k < before.poses.size(); ++k)
    EXPECT_EQ(after.poses[k].shift(), before.poses[k].shift());
}

TEST(AddToConsensus, theFrameOfTheConsensusIsKept) {
  Block block;
  const AddedToConsensus here = block.added();
  const Transform2D motion{12, 50, 1.3};
  for (Transform2D& pose : block.poses) pose = motion * pose;
  const AddedToConsensus there = block.added();
  EXPECT_NEAR(there.error.error, here.error.error, 0.01);
  for (std::size_t k = 0; k < here.poses.size(); ++k)
    EXPECT_LT(distance((motion * here.poses[k]).shift(), there.poses[k].shift()), 0.02) << k;
}

}  // namespace
}  // namespace roomgraph
