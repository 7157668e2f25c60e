#include "whole_poses.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace roomgraph
