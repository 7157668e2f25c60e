#include "fitted_consensus.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/consensus/belief.h"
#include "scoring_document.h"

namespace roomgraph {
namespace {

using namespace fitted;
using test::expectSaid;

TEST(ConsensusDocument, saysHowScansAreTracked) {
  expectSaid("that lie on walls, less %g.", kLeastQuality);
  expectSaid("is under %g m and %g rad, %g if it is larger", kSteadyTrack.place, kSteadyTrack.turn,
             kJumpCost);
  expectSaid("(a break), and %g if it does not", kFarCost);
  expectSaid("begins more than %g rad or %g m from the pose of the pair costs %g", kAsMapsBend.turn,
             kAsMapsBend.place, 2 * kJumpCost);
  expectSaid("Up to %zu scans may be lost along the way", kMemory);
  expectSaid("if at least %g %% of its walls lie within %g m of walls", 100 * kLeastQuality,
             kSameWall);
}

TEST(ConsensusDocument, saysWhatARunTellsOfItself) {
  EXPECT_EQ(kLeastLostOnEnd, 3);
  expectSaid("no other step within three scans is wrong, the scans behind the step, up to %zu",
             kLongScans);
  expectSaid("hardly holds (its weight is %g)", beliefOf(0));
}

TEST(ConsensusDocument, saysWhatThePosesCost) {
  expectSaid("√(%g² + %g² · *l*) m", kLinkNoise.place, kLinkNoisePerRootMetre.place);
  expectSaid("√(%g² + %g² · *l* + %g² · *a*) rad", kLinkNoise.turn, kLinkNoisePerRootMetre.turn,
             kLinkTurnPerRootRadian);
  expectSaid("times the slack | Cauchy, %g | 1 |", kLinkWidth);
  expectSaid("| match | %g m | %g rad | Cauchy, %g | %g · share", kMatchNoise.place,
             kMatchNoise.turn, kMatchWidth, kMatchWeight);
  expectSaid("| same scan in two runs | %g m | %g rad | Cauchy, %g | %g |", kMatchNoise.place / 2,
             kMatchNoise.turn / 2, kMatchWidth, 2 * kMatchWeight);
  expectSaid("| stretch of the links of a run | %g %% | | Cauchy, 1 | 1 |", 100 * kUsualStretch);
  expectSaid("differs from it by %g %% or more", 100 * kUsualStretch);
  expectSaid("| | %g rad | Tukey, %g | up to 1 |", kAxesTurn, kAxesWidth);
  expectSaid("of %zu scans and of the %zu that follow after a gap of %zu differ", kBesideTurn,
             kBesideTurn, 2 * kAcrossTurn);
  expectSaid("%g rad, the axes turn, unless either set scatters by %g rad or more", kAxesJump,
             kAxesTurn);
  expectSaid("They start %g times as wide", double(kFirstWidening));
}

TEST(ConsensusDocument, saysHowFarMatchGroupsAreBelieved) {
  expectSaid("within %g m and %g rad of the initial poses", kRoughly.place, kRoughly.turn);
  expectSaid("once the graph is solved, within %g m and %g rad", kSameAnswer.place,
             kSameAnswer.turn);
  expectSaid("Rejecting a match group of *m* matches costs %g √*m*,", kGivingUp);
}

TEST(ConsensusDocument, saysWhichStepsAreHeld) {
  expectSaid("changes by more than %g m or %g rad", kInlier.place, kInlier.turn);
  expectSaid("its weight becomes %g.", kHeldShare);
  expectSaid("The graph is then solved again, up to %d times", kHoldRounds);
}

TEST(ConsensusDocument, saysHowFarLinksGiveWay) {
  EXPECT_DOUBLE_EQ(1 - kCountedLinks, 0.1);
  expectSaid("without the worst tenth");
  expectSaid("without the worst tenth, at least %g and at most 1", kLeastSlack);
  expectSaid("its slack is at least %g.", kLeastSharedSlack);
}

TEST(ConsensusDocument, saysHowWideTheIntervalIs) {
  expectSaid("ln *f* = 1.28 · (%g + %g / *w*² + %g · (1 − *v*))", kFactor, kFactorPerRun,
             kFactorUnseen);
  expectSaid("*p* = %g %% · *r* + %g m / *w*", 100 * kUsualStretch / 2, kMetresPerRun);
  expectSaid("costs at most %g times as much as the best", kAboutAsGood);
}

TEST(ConsensusDocument, saysWhatNobodyBearsOut) {
  expectSaid("Long ones (%zu scans, or %g m of path) do not", kLongScans, kLongWay);
  expectSaid("for %ld scans in a row, another run knows", kLeastLostOnEnd);
  expectSaid("no run that does has more than %g %% of its walls", 100 * kLeastQuality);
  expectSaid("%.2f times their drift", kEightyPercent);
  expectSaid("a long stretch (%zu scans, or %g m of path) that was not found", kLongScans,
             kLongWay);
  expectSaid("a jump to there, on the robot's way, costs %g *h* + %g (1 − *h*).", kJumpCost,
             kJumpCost / 4);
  expectSaid("a jump elsewhere costs %g *h* + %g (1 − *h*).", kFarCost, 2 * kJumpCost);
}

TEST(ConsensusDocument, saysWhatJitterCosts) {
  expectSaid("If *j* exceeds %g m, which", kUsualJitter);
  expectSaid("√(*e*² + *j*² − *t*² − %g² m²)", kUsualJitter);
  expectSaid("divided and multiplied by %g", kJitterFactor);
}

}  // namespace
}  // namespace roomgraph
