#include "move_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "RandomNumbers.h"
#include "belief.h"
#include "drawn_submaps.h"
#include "graph_terms.h"

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

/** What the whole graph costs, each piece believed as far as the poses bear it out. */
double costOf(const TwoRuns& two) {
  constexpr double kLenient = 4;
  double cost = 0;
  for (std::size_t r = 0; r < two.runs.size(); ++r)
    for (const SubmapLink& link : two.runs[r].links)
      cost += linkTerm(two.runs[r], link, 1).cost(two.poses[r][link.from], two.poses[r][link.to]);
  for (const RunMatches& piece : two.matches) {
    double sum = 0, borneOut = 0;
    for (const SubmapMatch& match : piece.matches) {
      const Transform2D &in = two.poses[piece.in][match.in],
                        &of = two.poses[piece.of][match.submap];
      GraphTerm term = matchTerm(match, 1);
      term.noise = term.noise.times(kLenient);
      sum += term.cost(in, of);
      borneOut += isBorneOut(match, in, of, kBorneOut);
    }
    const double belief = beliefOf(borneOut / double(piece.matches.size()));
    cost += belief * sum + (1 - belief) * costOfGivingUp(piece);
  }
  return cost;
}

TEST(MovePieces, neverMakesTheGraphDearerWhateverLiesElsewhere) {
  test::RandomNumbers random(5);
  for (int i = 0; i < 30; ++i) {
    TwoRuns two;
    for (int stretch = 0; stretch < 3; ++stretch) {
      const std::size_t r = random.below(2), first = random.below(two.poses[r].size());
      const std::size_t last = first + random.below(two.poses[r].size() - first);
      const Transform2D wrong = random.pose(20);
      for (std::size_t k = first; k <= last; ++k) two.poses[r][k] = wrong * two.poses[r][k];
    }
    const double before = costOf(two);
    movePieces({two.runs, two.matches, {1, 1}, {}, {}}, two.poses);
    const double after = costOf(two);
    EXPECT_LE(after, before + 1e-9) << i;
    const SubmapPoses once = two.poses;
    movePieces({two.runs, two.matches, {1, 1}, {}, {}}, two.poses);
    EXPECT_LE(costOf(two), after + 1e-9) << i;
    if (after < 1) {
      EXPECT_EQ(test::misplaced(two.poses, once), 0) << "what is home stays";
    }
  }
}

TEST(MovePieces, theFrameOfTheSiteChangesNothing) {
  TwoRuns here, there;
  here.misplace(10, 17);
  const Transform2D motion{-40, 13, 2.5};
  for (std::size_t r = 0; r < 2; ++r) there.poses[r] = test::moved(here.poses[r], motion);
  here.misplacedAfterMoving(), there.misplacedAfterMoving();
  for (std::size_t r = 0; r < 2; ++r)
    for (std::size_t k = 0; k < here.poses[r].size(); ++k)
      EXPECT_LT(distance((motion * here.poses[r][k]).shift(), there.poses[r][k].shift()), 1e-9);
}

TEST(MovePieces, patchesAreNotMoved) {
  TwoRuns two;
  two.misplace(20, 24);
  two.runs[1].areScans = false;
  const SubmapPoses before = two.poses;
  movePieces({two.runs, two.matches, {1, 1}, {}, 0}, two.poses);
  EXPECT_EQ(test::misplaced(two.poses, before), 0);
}

TEST(MovePieces, ofNothingNothingMoves) {
  SubmapPoses none;
  movePieces({{}, {}, {}, {}, {}}, none);
  EXPECT_TRUE(none.empty());
  SubmapPoses empty(2);
  movePieces({{{}, {}}, {}, {1, 1}, {}, {}}, empty);
  EXPECT_TRUE(empty[0].empty());
}

}  // namespace
}  // namespace roomgraph
