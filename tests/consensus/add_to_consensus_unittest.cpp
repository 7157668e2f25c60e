#include "roomgraph/consensus/add_to_consensus.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_submaps.h"
#include "roomgraph/consensus/find_consensus.h"

namespace roomgraph {
namespace {

using test::drawnSubmaps;
using test::roundTheBlock;
using test::Way;

/** Three sound runs where they really lie, and one that is torn and in a frame of its own. */
struct Block {
  std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3), roundTheBlock(0.6),
                         roundTheBlock(0.9)};
  Way drawn = test::moved(test::torn(truth[3], 30, M_PI / 2, {3, 4}), {0, 9, -1});
  std::vector<RunMatches> matches = test::exactMatches(truth);
  SubmapPoses poses{truth[0], truth[1], truth[2], {}};

  std::vector<RunSubmaps> runs() const {
    return {drawnSubmaps(truth[0]), drawnSubmaps(truth[1]), drawnSubmaps(truth[2]),
            drawnSubmaps(drawn)};
  }
};

TEST(AddToConsensus, aRunIsPutWhereTheOthersSayThatItLies) {
  const Block block;
  const AddedToConsensus added = addToConsensus(block.runs(), 3, block.matches, block.poses);
  ASSERT_EQ(added.poses.size(), block.truth[3].size());
  for (std::size_t k = 0; k < added.poses.size(); ++k)
    EXPECT_LT(distance(added.poses[k].shift(), block.truth[3][k].shift()), 0.02) << k;
  const double really = test::displacement(block.drawn, block.truth[3]);
  ASSERT_GT(really, 0.3);
  EXPECT_NEAR(added.error.error, really, 0.05 * really);
  EXPECT_LT(added.error.low, really);
  EXPECT_GT(added.error.high, really);
  EXPECT_EQ(added.error.seen, 1);
}

TEST(AddToConsensus, itIsWhatAllRunsTogetherComeTo) {
  const Block block;
  const auto runs = block.runs();
  ConsensusOptions options;
  options.reference = 0;
  const SubmapPoses together = findConsensus(runs, block.matches, options).best;
  const auto error = mapErrors(runs, block.matches, together)[3];
  const AddedToConsensus added = addToConsensus(runs, 3, block.matches, block.poses);
  EXPECT_NEAR(added.error.error, error.error, 0.01);
  EXPECT_NEAR(added.error.low, error.low, 0.01) << "as many runs have their say";
  EXPECT_NEAR(added.error.high, error.high, 0.01);
}

TEST(AddToConsensus, fewJudgesTellLess) {
  const Block block;
  std::vector<RunMatches> withOne;
  for (const RunMatches& piece : block.matches)
    if (piece.of + piece.in == 3) withOne.push_back(piece);
  const MapError many = addToConsensus(block.runs(), 3, block.matches, block.poses).error;
  const MapError few = addToConsensus(block.runs(), 3, withOne, block.poses).error;
  EXPECT_GT(few.high - few.low, many.high - many.low);
}

TEST(AddToConsensus, aRunThatNobodyHasSeenKeepsItsShape) {
  const Block block;
  const AddedToConsensus added = addToConsensus(block.runs(), 3, {}, block.poses);
  EXPECT_LT(test::misplaced({added.poses}, {block.drawn}), 1e-6);
  EXPECT_EQ(added.error.seen, 0);
}

TEST(AddToConsensus, matchesOfOthersHaveNoSay) {
  const Block block;
  const AddedToConsensus before = addToConsensus(block.runs(), 3, block.matches, block.poses);
  std::vector<RunMatches> matches = block.matches;
  for (RunMatches& piece : matches)
    if (piece.of != 3 && piece.in != 3)
      for (SubmapMatch& match : piece.matches) match.pose.x += 4;
  const AddedToConsensus after = addToConsensus(block.runs(), 3, matches, block.poses);
  EXPECT_EQ(after.error.error, before.error.error);
  EXPECT_EQ(after.error.high, before.error.high);
  for (std::size_t k = 0; k < before.poses.size(); ++k)
    EXPECT_EQ(after.poses[k].shift(), before.poses[k].shift());
}

TEST(AddToConsensus, theFrameOfTheConsensusIsKept) {
  Block block;
  const AddedToConsensus here = addToConsensus(block.runs(), 3, block.matches, block.poses);
  const Transform2D motion{12, 50, 1.3};
  for (Way& way : block.poses) way = test::moved(way, motion);
  const AddedToConsensus there = addToConsensus(block.runs(), 3, block.matches, block.poses);
  EXPECT_NEAR(there.error.error, here.error.error, 0.01);
  for (std::size_t k = 0; k < here.poses.size(); ++k)
    EXPECT_LT(distance((motion * here.poses[k]).shift(), there.poses[k].shift()), 0.02) << k;
}

}  // namespace
}  // namespace roomgraph
