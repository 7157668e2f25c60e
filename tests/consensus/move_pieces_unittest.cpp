#include "move_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "drawn_submaps.h"

namespace roomgraph {
namespace {

using test::drawnSubmaps;
using test::roundTheBlock;
using test::Way;

/** Two sound runs round a block, and poses of which some key frames of the second lie elsewhere. */
struct TwoRuns {
  std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3)};
  std::vector<RunSubmaps> runs{drawnSubmaps(truth[0]), drawnSubmaps(truth[1])};
  std::vector<RunMatches> matches = test::exactMatches(truth);
  SubmapPoses poses = truth;

  void misplace(std::size_t first, std::size_t last) {
    const Transform2D wrong{27, 0, 0};
    for (std::size_t k = first; k <= last; ++k) poses[1][k] = wrong * poses[1][k];
  }

  double misplacedAfterMoving(std::optional<std::size_t> reference = {}) {
    movePieces({runs, matches, {1, 1}, {}, reference}, poses);
    return test::misplaced(poses, truth);
  }
};

TEST(MovePieces, bringsHomeWhatBothItsLinksHaveLetGo) {
  for (const std::size_t last : {20u, 21u, 27u}) {
    TwoRuns two;
    two.misplace(20, last);
    EXPECT_LT(two.misplacedAfterMoving(), 1e-6) << last;
  }
}

TEST(MovePieces, bringsHomeSeveralPiecesAndBothEnds) {
  TwoRuns two;
  two.misplace(0, 4);
  two.misplace(20, 20);
  two.misplace(30, two.poses[1].size() - 1);
  EXPECT_LT(two.misplacedAfterMoving(), 1e-6);
}

TEST(MovePieces, bringsHomeAWholeRun) {
  TwoRuns two;
  two.misplace(0, two.poses[1].size() - 1);
  EXPECT_LT(two.misplacedAfterMoving(), 1e-6);
}

TEST(MovePieces, tearsARunWhereAPieceThatIsGivenUpWouldHaveIt) {
  TwoRuns two;
  // Drawn torn, and laid down as one: no link has given way, but what was found of its end lies
  // elsewhere.
  const Way torn = test::torn(two.truth[1], 25, 0, {3, 4});
  two.runs[1] = drawnSubmaps(torn);
  two.poses[1] = torn;
  std::vector<RunMatches> cut;
  for (RunMatches& piece : two.matches) {
    RunMatches front = piece, back = piece;
    const auto isFront = [&](const SubmapMatch& m) {
      return (piece.of == 1 ? m.submap : m.in) < 25;
    };
    front.matches.erase(std::stable_partition(front.matches.begin(), front.matches.end(), isFront),
                        front.matches.end());
    back.matches.erase(back.matches.begin(),
                       std::stable_partition(back.matches.begin(), back.matches.end(), isFront));
    cut.push_back(front), cut.push_back(back);
  }
  two.matches = cut;
  EXPECT_LT(two.misplacedAfterMoving(0), 1e-6);
}

TEST(MovePieces, leavesWhatLiesWhereItBelongs) {
  TwoRuns two;
  EXPECT_EQ(two.misplacedAfterMoving(), 0);
  // Torn in truth: all its matches say so, against one link.
  two.runs[1] = drawnSubmaps(test::torn(two.truth[1], 25, 1.2, {3, 4}));
  EXPECT_EQ(two.misplacedAfterMoving(), 0);
}

TEST(MovePieces, theReferenceStays) {
  TwoRuns two;
  two.misplace(20, 22);
  const SubmapPoses before = two.poses;
  movePieces({two.runs, {}, {1, 1}, {}, 1}, two.poses);
  EXPECT_EQ(test::misplaced(two.poses, before), 0);
}

}  // namespace
}  // namespace roomgraph
