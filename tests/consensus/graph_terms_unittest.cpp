#include "graph_terms.h"

#include <gtest/gtest.h>

#include <cmath>

#include "RandomNumbers.h"
#include "drawn_submaps.h"

namespace roomgraph {
namespace {

constexpr double kExact = 1e-9;

/** A term as wide as it is exact. */
GraphTerm term(const Transform2D& measured) { return {measured, {0.1, 0.02}, 3, 1}; }

TEST(LinkNoise, growsWithTheWayAndTheTurnWhateverItsDirection) {
  const LinkNoise rest = linkNoise({}), step = linkNoise({1, 0, 0}), turn = linkNoise({0, 0, 1});
  EXPECT_GT(rest.place, 0) << "a key frame is never exact";
  EXPECT_GT(rest.turn, 0);
  EXPECT_GT(step.place, rest.place);
  EXPECT_GT(step.turn, rest.turn) << "a way turns, too";
  EXPECT_EQ(turn.place, rest.place);
  EXPECT_GT(turn.turn, rest.turn);
  EXPECT_EQ(linkNoise({0, 0, -1}).turn, turn.turn);
  EXPECT_NEAR(linkNoise({0.6, -0.8, 0}).place, step.place, kExact);
}

TEST(LinkNoise, ofTwoStepsInARowTheVariancesAddUp) {
  const auto variance = [](const Transform2D& step) {
    const LinkNoise noise = linkNoise(step), rest = linkNoise({});
    return noise.place * noise.place - rest.place * rest.place;
  };
  EXPECT_NEAR(variance({5, 0, 0}), 5 * variance({1, 0, 0}), kExact);
}

TEST(GraphTerm, costsNothingWhereThePosesAreAsMeasured) {
  test::RandomNumbers random(1);
  for (int i = 0; i < 50; ++i) {
    const Transform2D measured = random.pose(5), from = random.pose(50);
    EXPECT_NEAR(term(measured).cost(from, from * measured), 0, kExact);
  }
}

TEST(GraphTerm, theFrameOfTheSiteChangesNothing) {
  test::RandomNumbers random(2);
  for (int i = 0; i < 50; ++i) {
    const GraphTerm t = term(random.pose(2));
    const Transform2D from = random.pose(5), to = random.pose(5), motion = random.pose(30);
    EXPECT_NEAR(t.cost(motion * from, motion * to), t.cost(from, to), 1e-6);
  }
}

TEST(GraphTerm, theSameMatchSeenFromItsOtherSubmapCostsAsMuch) {
  test::RandomNumbers random(3);
  for (int i = 0; i < 50; ++i) {
    const Transform2D measured = random.pose(2), from = random.pose(5);
    // What is shifted only: a turn is about the one submap or about the other.
    const Point off = random.place(1);
    const Transform2D found = from * measured, to{found.x + off.x, found.y + off.y, found.phi};
    EXPECT_NEAR(term(measured.inverse()).cost(to, from), term(measured).cost(from, to), 1e-6);
  }
}

TEST(GraphTerm, isHalfTheSquareForWhatIsLittleOff) {
  const GraphTerm t = term({1, 0, 0});
  EXPECT_NEAR(t.cost({}, {1.01, 0, 0}), 0.5 * 0.1 * 0.1, 1e-4);
  EXPECT_NEAR(t.cost({}, {1, 0, 0.004}), 0.5 * 0.2 * 0.2, 1e-3);
  EXPECT_NEAR(t.cost({}, {1, -0.01, 0}), t.cost({}, {1, 0.01, 0}), kExact);
}

TEST(GraphTerm, letsGoOfWhatIsFarOff) {
  const GraphTerm t = term({});
  double last = 0, gain = HUGE_VAL;
  for (const double off : {1.0, 2.0, 4.0, 8.0, 16.0}) {
    const double cost = t.cost({}, {off, 0, 0});
    EXPECT_GT(cost, last) << off;
    EXPECT_LT(cost, 0.5 * off * off / 0.1 / 0.1) << "less than its square";
    if (off > 2) {
      EXPECT_LE(cost - last, 1.05 * gain) << "each doubling costs about the same";
    }
    gain = cost - last, last = cost;
  }
}

TEST(GraphTerm, aTurnIsTakenTheShortWayRound) {
  EXPECT_NEAR(term({0, 0, M_PI - 0.01}).cost({}, {0, 0, -M_PI + 0.01}),
              term({0, 0, 0.01}).cost({}, {0, 0, -0.01}), kExact);
}

TEST(LinkTerm, aSlackRunGivesWayMoreCheaply) {
  RunSubmaps run = test::drawnSubmaps({{}, {1, 0, 0}});
  const Transform2D off{1.2, 0, 0.05};
  const double stiff = linkTerm(run, run.links[0], 0.5).cost({}, off);
  const double ordinary = linkTerm(run, run.links[0], 1).cost({}, off);
  EXPECT_GT(stiff, ordinary);
  EXPECT_NEAR(linkTerm(run, run.links[0], 1).cost({}, {1, 0, 0}), 0, kExact);
}

TEST(MatchTerm, countsAsFarAsItIsBelievedAndItsWallsWereFound) {
  SubmapMatch match;
  match.weight = 0.8;
  const Transform2D off{0.2, 0.1, 0.02};
  const double full = matchTerm(match, 1).cost({}, off);
  EXPECT_NEAR(matchTerm(match, 0.25).cost({}, off), 0.25 * full, kExact);
  match.weight = 0.4;
  EXPECT_NEAR(matchTerm(match, 1).cost({}, off), 0.5 * full, kExact);
  EXPECT_EQ(matchTerm(match, 0).cost({}, off), 0);
}

TEST(MatchTerm, oneScanOfBothRunsHoldsThemCloser) {
  SubmapMatch match;
  match.weight = 1;
  const Transform2D off{0.1, 0, 0};
  const double found = matchTerm(match, 1).cost({}, off);
  match.isSameScan = true;
  EXPECT_GT(matchTerm(match, 1).cost({}, off), 2 * found);
}

}  // namespace
}  // namespace roomgraph
