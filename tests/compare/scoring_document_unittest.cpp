#include "scoring_document.h"

#include "roomgraph/align/near_poses.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/breaks/find_pieces.h"
#include "roomgraph/breaks/site_breaks.h"
#include "roomgraph/compare/run_score.h"
#include "roomgraph/consensus/estimate_map_errors.h"
#include "roomgraph/relate/estimate_scale.h"
#include "roomgraph/relate/follow_walls.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {
namespace {

using test::degrees;
using test::expectSaid;

TEST(ScoringDocument, saysWhereABreakBegins) {
  expectSaid("that pose turns by %g degrees", degrees(kBreakRotation));
  expectSaid("moves by %g m from one scan to the next", kBreakShift);
  expectSaid("where the pose turns by %g degrees or", degrees(kApartRotation));
  expectSaid("moves by %g m within three scans", kApartShift);
  expectSaid("differ by %g degrees or ", degrees(kBreakRotation));
  expectSaid(" degrees or %g m, and by", kBreakShift);
  expectSaid("and by %g times what they bend themselves", kPieceContrast);
  expectSaid("turned by %g degrees (root mean square)", degrees(kBreakRotation));
  expectSaid("runs with more than %g %% of the votes", 100 * kMajority);
  expectSaid("have %g %% of this one's walls are consulted", 100 * kWitnessShare);
  expectSaid("the smaller fragment holds %g %% of the walls found", 100 * kSmallestPiece);
  expectSaid("(within %g degrees and %g m)", std::round(degrees(kSameAnswer.turn)),
             kSameAnswer.place);
}

TEST(ScoringDocument, saysHowRunsArePlaced) {
  expectSaid("with a confidence of at least %g,", kMinPairConfidence);
  expectSaid("disagrees with the rest by more than %g m has little weight", kMaxMisfit);
  EXPECT_EQ(CompareRunsOptions().core, 12);
  expectSaid("With more than twelve runs");
}

TEST(ScoringDocument, saysHowErrorsFollowFromBends) {
  expectSaid("log((*b(ij)* + %g m) / (√(*e(i)*² + *e(j)*²) + %g m))", fitted::kBendNoise,
             fitted::kBendNoise);
  expectSaid("+ %g · Σ over runs of *c(i)* · ρ(log(*e(i)* + %g m) − %g · log(*d(i)* + %g) − *a*)",
             fitted::kDeviationWeight, fitted::kErrorNoise, fitted::kDeviationPower,
             fitted::kDeviationNoise);
  expectSaid("with width %g if a bend is larger", fitted::kBendAbove);
  expectSaid("width %g for the deviations", fitted::kDeviationWidth);
  expectSaid("(pseudo-Huber, width %g)", fitted::kBendBelow);
  expectSaid("Errors are at most %g m", kMaxBend);
  expectSaid("√(%g² · *k* + %g²)", fitted::kErrorSpread, fitted::kLeastErrorSpread);
  expectSaid("Its upper end is at least %g m", fitted::kBendNoise);
}

TEST(ScoringDocument, saysWhatIsMeaningful) {
  const CompareRunsOptions score;
  expectSaid("fewer than %g wall points", kFewestWalls);
  expectSaid("no other run shares %g %% of the walls", 100 * score.leastShare);
  expectSaid("exp(−map error / %g m)", score.scoreScale);
  expectSaid("1 / (%g m + map error)⁴", kTrustFloor);
}

TEST(ScoringDocument, saysWhenAScaleIsFound) {
  expectSaid("with a probability of %g, have", kMinScaleConfidence);
  expectSaid("that is 10 %% away by %g", kMinScaleMargin);
  expectSaid("Every %g %%, the picture", 100 * kScaleStep);
}

TEST(ScoringDocument, saysWhereTheGateFails) {
  expectSaid("`--fail-on coverage` fails below %g %%", 100 * kNearlyAll);
}

}  // namespace
}  // namespace roomgraph
