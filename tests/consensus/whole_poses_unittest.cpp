#include "whole_poses.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_submaps.h"

namespace roomgraph {
namespace {

using test::drawnSubmaps;
using test::roundTheBlock;
using test::Way;

/** Three runs in frames of their own. */
struct ThreeRuns {
  std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3), roundTheBlock(0.6)};
  std::vector<RunSubmaps> runs{drawnSubmaps(truth[0]),
                               drawnSubmaps(test::moved(truth[1], {7, -3, 2})),
                               drawnSubmaps(test::moved(truth[2], {-1, 9, -1}))};
  std::vector<RunMatches> matches = test::exactMatches(truth);

  double misplaced(std::optional<std::size_t> reference = {}) const {
    return test::misplaced(wholePoses(runs, matches, reference), truth);
  }

  /** Some matches of a piece say that the run lies elsewhere. */
  void mislead(RunMatches& piece, std::size_t first, std::size_t last) {
    const Transform2D wrong{27, 5, M_PI};
    for (std::size_t m = first; m < last; ++m) {
      SubmapMatch& match = piece.matches[m];
      match.pose = truth[piece.in][match.in].inverse() * wrong * truth[piece.of][match.submap];
    }
  }
};

TEST(WholePoses, allRunsLieWhereTheirMatchesHaveThem) { EXPECT_LT(ThreeRuns().misplaced(), 1e-9); }

TEST(WholePoses, noRunIsTorn) {
  ThreeRuns three;
  three.runs[2] = drawnSubmaps(test::torn(three.truth[2], 40, 1, {5, 6}));
  const SubmapPoses poses = wholePoses(three.runs, three.matches, {});
  for (const SubmapLink& link : three.runs[2].links) {
    const auto& submaps = three.runs[2].submaps;
    const Transform2D drawn = submaps[link.from].pose.inverse() * submaps[link.to].pose;
    const Transform2D now = poses[2][link.from].inverse() * poses[2][link.to];
    EXPECT_LT(distance(drawn.shift(), now.shift()), 1e-9);
  }
  EXPECT_LT(distance(poses[2][0].shift(), three.truth[2][0].shift()), 1e-9)
      << "the larger part lies where it belongs";
}

TEST(WholePoses, mostMatchesOfAllRunsDecide) {
  ThreeRuns three;
  // The pieces of the first two in each other are more than half wrong: the third tells better.
  for (RunMatches& piece : three.matches)
    if (piece.of + piece.in == 1) three.mislead(piece, 10, piece.matches.size());
  EXPECT_LT(three.misplaced(), 1e-9);
}

TEST(WholePoses, theReferenceStays) {
  const ThreeRuns three;
  const SubmapPoses poses = wholePoses(three.runs, three.matches, 1);
  for (std::size_t k = 0; k < poses[1].size(); ++k)
    EXPECT_LT(distance(poses[1][k].shift(), three.runs[1].submaps[k].pose.shift()), 1e-9);
  EXPECT_LT(three.misplaced(1), 1e-9);
}

TEST(WholePoses, aRunThatWasFoundNowhereKeepsItsPoses) {
  const ThreeRuns three;
  const SubmapPoses poses = wholePoses({three.runs[0], three.runs[1], {}}, {}, {});
  EXPECT_LT(distance(poses[1][5].shift(), three.runs[1].submaps[5].pose.shift()), 1e-9);
  EXPECT_TRUE(poses[2].empty());
}

TEST(WholePoses, theOrderOfRunsAndPiecesChangesTheFrameAtMost) {
  ThreeRuns three;
  three.mislead(three.matches[2], 0, 20);
  const SubmapPoses before = wholePoses(three.runs, three.matches, {});
  std::reverse(three.runs.begin(), three.runs.end());
  std::reverse(three.matches.begin(), three.matches.end());
  for (RunMatches& piece : three.matches) piece.of = 2 - piece.of, piece.in = 2 - piece.in;
  const SubmapPoses after = wholePoses(three.runs, three.matches, {});
  EXPECT_LT(test::misplaced(after, {before[2], before[1], before[0]}), 1e-9);
}

TEST(WholePoses, theFirstRunGivesTheFrame) {
  const ThreeRuns three;
  const SubmapPoses poses = wholePoses(three.runs, three.matches, {});
  for (std::size_t k = 0; k < poses[0].size(); ++k)
    EXPECT_EQ(poses[0][k].shift(), three.runs[0].submaps[k].pose.shift());
}

TEST(WholePoses, aMatchCountsAsMuchAsOfItWasFound) {
  ThreeRuns three;
  // Two pieces contradict each other: the smaller one was found better.
  RunMatches wrong, right;
  for (const RunMatches& piece : three.matches)
    if (piece.of == 1 && piece.in == 0) wrong = right = piece;
  three.mislead(wrong, 0, wrong.matches.size());
  right.matches.resize(20);
  for (SubmapMatch& match : wrong.matches) match.weight = 0.1;
  three.matches = {wrong, right};
  three.runs.resize(2), three.truth.resize(2);
  EXPECT_LT(three.misplaced(), 1e-9);
  for (SubmapMatch& match : three.matches.front().matches) match.weight = 1;
  EXPECT_GT(three.misplaced(), 5) << "there are more of the others";
}

TEST(WholePoses, aRunIsPlacedThroughAnother) {
  ThreeRuns three;
  three.matches.erase(std::remove_if(three.matches.begin(), three.matches.end(),
                                     [](const RunMatches& m) { return m.of + m.in == 2; }),
                      three.matches.end());  // the first and the last never met
  EXPECT_LT(three.misplaced(), 1e-9);
}

}  // namespace
}  // namespace roomgraph
