#include "roomgraph/consensus/find_consensus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_submaps.h"
#include "roomgraph/consensus/map_errors.h"

namespace roomgraph {
namespace {

using test::drawnSubmaps;
using test::roundTheBlock;
using test::Way;

/** A sound run, one that drifts, and one that is torn, each in a frame of its own. */
struct ThreeRuns {
  std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3), roundTheBlock(0.6)};
  std::vector<Way> drawn{test::moved(truth[0], {1, 2, 0.3}),
                         test::moved(test::drifting(truth[1], 0.004), {-5, 0, 2}),
                         test::moved(test::torn(truth[2], 30, M_PI / 2, {3, 4}), {0, 9, -1})};
  std::vector<RunMatches> matches = test::exactMatches(truth);

  std::vector<RunSubmaps> runs() const {
    std::vector<RunSubmaps> runs;
    for (const Way& way : drawn) runs.push_back(drawnSubmaps(way));
    return runs;
  }
};

TEST(FindConsensus, allRunsLieWhereTheyReallyAre) {
  ThreeRuns three;
  EXPECT_LT(test::misplaced(findConsensus(three.runs(), three.matches, {}).best, three.truth),
            0.02);
  three.drawn[1] = three.truth[1];
  EXPECT_LT(test::misplaced(findConsensus(three.runs(), three.matches, {}).best, three.truth),
            0.002)
      << "without a drift nothing pulls at what is sound";
}

TEST(FindConsensus, theErrorOfEachRunIsThatWhichItHas) {
  const ThreeRuns three;
  const auto runs = three.runs();
  const auto errors = mapErrors(runs, three.matches, findConsensus(runs, three.matches, {}).best);
  EXPECT_LT(errors[0].error, 0.02);
  for (const std::size_t r : {1u, 2u}) {
    const double really = test::displacement(three.drawn[r], three.truth[r]);
    ASSERT_GT(really, 0.3);
    EXPECT_NEAR(errors[r].error, really, 0.05 * really) << r;
  }
}

TEST(FindConsensus, aRunMayBeTornByAnyTurn) {
  for (const double turn : {-0.3, 1.0, M_PI}) {
    ThreeRuns three;
    three.drawn[2] = test::torn(three.truth[2], 25, turn, {-4, 3});
    EXPECT_LT(test::misplaced(findConsensus(three.runs(), three.matches, {}).best, three.truth),
              0.02)
        << turn;
  }
}

/** Seven runs, one of them torn and one that drifts: so many are first solved with few nodes. */
struct ManyRuns {
  std::vector<Way> truth, drawn;
  std::vector<RunSubmaps> runs;
  std::vector<RunMatches> matches;

  ManyRuns() {
    for (const double offset : {0.0, 0.2, 0.4, 0.6, 0.8, 0.1, 0.5})
      truth.push_back(roundTheBlock(offset));
    drawn = truth;
    drawn[2] = test::moved(test::torn(truth[2], 29, 2, {-4, 3}), {0, 9, -1});
    drawn[4] = test::moved(test::drifting(truth[4], 0.004), {-5, 0, 2});
    for (const Way& way : drawn) runs.push_back(drawnSubmaps(way));
    matches = test::exactMatches(truth);
  }
};

TEST(FindConsensus, manyRunsLieWhereTheyReallyAre) {
  const ManyRuns many;
  EXPECT_LT(test::misplaced(findConsensus(many.runs, many.matches, {}).best, many.truth), 0.01);
}

TEST(FindConsensus, aReferenceOfManyRunsStaysExactlyAsItIs) {
  const ManyRuns many;
  ConsensusOptions options;
  options.reference = 1;
  const SubmapPoses poses = findConsensus(many.runs, many.matches, options).best;
  for (std::size_t k = 0; k < poses[1].size(); ++k)
    EXPECT_EQ(poses[1][k].shift(), many.drawn[1][k].shift());
  EXPECT_LT(test::misplaced(poses, many.truth), 0.01);
}

TEST(FindConsensus, aPieceThatWasFoundInAnotherWingIsGivenUpAsAWhole) {
  // Two sound runs that were found in each other one wing off, as in a building that repeats
  // itself. Torn between that and the third, they could bend to fit both.
  ThreeRuns three;
  three.drawn = three.truth;
  const auto runs = three.runs();
  const Transform2D wingOff{0, 27, 0};
  std::vector<RunMatches> matches = three.matches;
  for (RunMatches& piece : matches) {
    if (piece.of + piece.in != 1) continue;
    for (SubmapMatch& match : piece.matches) {
      const Transform2D wrong = wingOff * three.truth[piece.of][match.submap];
      match.pose = three.truth[piece.in][match.in].inverse() * wrong;
    }
  }
  const SubmapPoses poses = findConsensus(runs, matches, {}).best;
  for (const MapError& error : mapErrors(runs, matches, poses)) EXPECT_LT(error.error, 0.05);
}

TEST(FindConsensus, tellsOtherAnswersThatAreAboutAsGood) {
  const ThreeRuns three;
  EXPECT_EQ(findConsensus(three.runs(), three.matches, {}).others.size(), 3u)
      << "all starts come to the same";
  for (const SubmapPoses& other : findConsensus(three.runs(), three.matches, {}).others) {
    const auto runs = three.runs();
    EXPECT_LT(mapErrors(runs, three.matches, other)[0].error, 0.05);
  }
}

TEST(FindConsensus, aWrongMatchAmongManyMovesNothing) {
  const ThreeRuns three;
  const SubmapPoses before = findConsensus(three.runs(), three.matches, {}).best;
  for (const Transform2D& wrong :
       {Transform2D{3, -2, M_PI / 2}, Transform2D{0.5, 0, 0}, Transform2D{0, 0, M_PI}}) {
    std::vector<RunMatches> matches = three.matches;
    for (RunMatches& pair : matches) pair.matches[20].pose = wrong * pair.matches[20].pose;
    EXPECT_LT(test::misplaced(findConsensus(three.runs(), matches, {}).best, before), 0.01);
  }
}

TEST(FindConsensus, theOrderOfTheRunsChangesTheFrameAtMost) {
  const ThreeRuns three;
  const SubmapPoses before = findConsensus(three.runs(), three.matches, {}).best;
  std::vector<std::size_t> order{0, 1, 2};
  while (std::next_permutation(order.begin(), order.end())) {
    std::vector<RunSubmaps> runs;
    std::vector<Way> expected;
    for (const std::size_t r : order)
      runs.push_back(drawnSubmaps(three.drawn[r])), expected.push_back(before[r]);
    const auto placeOf = [&](std::size_t run) {
      return std::size_t(std::find(order.begin(), order.end(), run) - order.begin());
    };
    std::vector<RunMatches> matches = three.matches;
    for (RunMatches& pair : matches) pair.of = placeOf(pair.of), pair.in = placeOf(pair.in);
    EXPECT_LT(test::misplaced(findConsensus(runs, matches, {}).best, expected), 0.005)
        << order[0] << order[1] << order[2];
  }
}

TEST(FindConsensus, aReferenceStaysExactlyAsItIs) {
  const ThreeRuns three;
  ConsensusOptions options;
  options.reference = 1;
  const SubmapPoses poses = findConsensus(three.runs(), three.matches, options).best;
  for (std::size_t k = 0; k < poses[1].size(); ++k) {
    EXPECT_EQ(poses[1][k].shift(), three.drawn[1][k].shift());
    EXPECT_NEAR(wrappedAngle(poses[1][k].phi - three.drawn[1][k].phi), 0, 1e-12);
  }
  EXPECT_LT(test::displacement(poses[0], poses[1]), 2.0) << "the others follow it";
}

TEST(FindConsensus, aRunThatNothingWasFoundOfKeepsItsPoses) {
  const ThreeRuns three;
  auto runs = three.runs();
  const Way lonely = test::moved(test::torn(three.truth[0], 10, 1, {2, 2}), {30, 0, 1});
  runs.push_back(drawnSubmaps(lonely));
  const SubmapPoses poses = findConsensus(runs, three.matches, {}).best;
  EXPECT_LT(test::misplaced({poses[3]}, {lonely}), 1e-6);
  EXPECT_LT(test::misplaced({poses[0], poses[1], poses[2]}, three.truth), 0.02);
}

TEST(FindConsensus, runsThatShareTheirScansDoNotOutvoteAnother) {
  const Way truth = roundTheBlock(), bent = test::drifting(truth, 0.004);
  std::vector<RunMatches> matches = test::exactMatches({truth, truth, truth});
  for (RunMatches& pair : matches)
    if (pair.of + pair.in == 3)  // 1 and 2 are of one log
      for (SubmapMatch& match : pair.matches) match.isSameScan = true;
  const std::vector<RunSubmaps> runs{drawnSubmaps(truth), drawnSubmaps(bent), drawnSubmaps(bent)};
  const auto errors = mapErrors(runs, matches, findConsensus(runs, matches, {}).best);
  EXPECT_LT(errors[0].error, 2 * errors[1].error);
}

TEST(FindConsensus, anyJobOrderGivesTheSameNumbers) {
  const ThreeRuns three;
  ConsensusOptions backwards;
  backwards.forEach = [](std::size_t count, const std::function<void(std::size_t)>& job) {
    while (count > 0) job(--count);
  };
  const SubmapPoses l = findConsensus(three.runs(), three.matches, {}).best;
  const SubmapPoses r = findConsensus(three.runs(), three.matches, backwards).best;
  for (std::size_t run = 0; run < l.size(); ++run)
    for (std::size_t k = 0; k < l[run].size(); ++k) {
      EXPECT_EQ(l[run][k].shift(), r[run][k].shift());
      EXPECT_EQ(l[run][k].phi, r[run][k].phi);
    }
}

TEST(FindConsensus, ofNoRunsThereIsNone) {
  EXPECT_TRUE(findConsensus({}, {}, {}).best.empty());
  EXPECT_EQ(findConsensus({{}, {}}, {}, {}).best.size(), 2u) << "runs without submaps";
}

}  // namespace
}  // namespace roomgraph
