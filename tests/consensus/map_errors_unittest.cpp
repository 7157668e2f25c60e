#include "roomgraph/consensus/map_errors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_submaps.h"

namespace roomgraph {
namespace {

using test::drawnSubmaps;
using test::roundTheBlock;
using test::Way;

TEST(MapErrors, aMapThatIsMovedAsAWholeHasNone) {
  const Way way = roundTheBlock();
  const Transform2D motion{4, -7, 2.5};
  const MapError error = mapErrors({drawnSubmaps(way)}, {}, {test::moved(way, motion)})[0];
  EXPECT_NEAR(error.error, 0, 1e-6);
  EXPECT_LT(distance(error.pose.shift(), motion.shift()), 1e-9);
  EXPECT_NEAR(wrappedAngle(error.pose.phi - motion.phi), 0, 1e-9);
  ASSERT_EQ(error.errors.size(), way.size());
  for (const double each : error.errors) EXPECT_NEAR(each, 0, 1e-6);
}

TEST(MapErrors, itIsTheDisplacementOfWhatWasDrawn) {
  const Way truth = roundTheBlock();
  for (const Way& drawn : {test::drifting(truth, 0.01), test::torn(truth, 20, 1.5, {3, 4}),
                           test::torn(truth, 50, M_PI, {})}) {
    const MapError error = mapErrors({drawnSubmaps(drawn)}, {}, {truth})[0];
    EXPECT_NEAR(error.error, test::displacement(drawn, truth), 1e-9);
  }
}

TEST(MapErrors, oneSubmapThatIsOffHasTheErrorOfItsPoints) {
  const Way truth = roundTheBlock();
  Way drawn = truth;
  drawn[7] = drawn[7] * Transform2D{0.5, -0.2, 0.4};
  const MapError error = mapErrors({drawnSubmaps(drawn)}, {}, {truth})[0];
  double squares = 0;
  for (const Point point : test::drawnPoints())
    squares += squaredNorm(error.pose(drawn[7](point)) - truth[7](point));
  EXPECT_NEAR(error.errors[7], std::sqrt(squares / double(test::drawnPoints().size())), 1e-9);
}

TEST(MapErrors, thoseOfTheSubmapsAddUp) {
  const Way truth = roundTheBlock();
  RunSubmaps run = drawnSubmaps(test::drifting(truth, 0.01));
  for (int i = 0; i < 20; ++i) run.submaps[40].points.add({2, 2});  // one has drawn more
  const MapError error = mapErrors({run}, {}, {truth})[0];
  double squares = 0, points = 0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    squares += run.submaps[k].points.count * error.errors[k] * error.errors[k];
    points += run.submaps[k].points.count;
  }
  EXPECT_NEAR(error.error, std::sqrt(squares / points), 1e-9);
}

TEST(MapErrors, theFrameOfThePosesChangesNothing) {
  const Way truth = roundTheBlock();
  const std::vector<RunSubmaps> runs{drawnSubmaps(test::torn(truth, 20, 1, {2, 0}))};
  const MapError one = mapErrors(runs, {}, {truth})[0];
  const MapError other = mapErrors(runs, {}, {test::moved(truth, {50, -80, 3})})[0];
  EXPECT_NEAR(one.error, other.error, 1e-9);
  EXPECT_NEAR(one.low, other.low, 1e-9);
  EXPECT_NEAR(one.high, other.high, 1e-9);
  for (std::size_t k = 0; k < truth.size(); ++k) EXPECT_NEAR(one.errors[k], other.errors[k], 1e-9);
}

TEST(MapErrors, theIntervalHoldsTheErrorAndIsWiderForWhatIsUnseen) {
  const Way truth = roundTheBlock();
  const std::vector<RunSubmaps> runs{drawnSubmaps(test::drifting(truth, 0.01)), drawnSubmaps(truth),
                                     drawnSubmaps(truth)};
  const SubmapPoses poses{truth, truth, truth};
  std::vector<RunMatches> matches = test::exactMatches(poses);
  const MapError seen = mapErrors(runs, matches, poses)[0];
  EXPECT_EQ(seen.seen, 1);
  for (RunMatches& pair : matches) pair.matches.resize(30);
  const MapError half = mapErrors(runs, matches, poses)[0];
  EXPECT_EQ(half.seen, 0.5);
  const MapError unseen = mapErrors(runs, {}, poses)[0];
  EXPECT_EQ(unseen.seen, 0);
  EXPECT_LT(seen.low, seen.error);
  EXPECT_GT(seen.high, seen.error);
  EXPECT_LT(half.low, seen.low);
  EXPECT_GT(half.high, seen.high);
  EXPECT_LT(unseen.low, half.low);
  EXPECT_GT(unseen.high, half.high);
  EXPECT_GE(unseen.low, 0);
}

TEST(MapErrors, theIntervalIsNarrowerForMoreRuns) {
  const Way truth = roundTheBlock(), drawn = test::drifting(truth, 0.01);
  double width = HUGE_VAL;
  for (const std::size_t runs : {2u, 3u, 6u}) {
    std::vector<RunSubmaps> all(runs, drawnSubmaps(truth));
    all[0] = drawnSubmaps(drawn);
    const std::vector<Way> poses(runs, truth);
    const MapError error = mapErrors(all, test::exactMatches(poses), poses)[0];
    EXPECT_LT(error.high - error.low, width) << runs;
    width = error.high - error.low;
  }
}

TEST(MapErrors, aRunThatHasDrawnNothingHasNone) {
  RunSubmaps blind = drawnSubmaps({{}, {1, 0, 0}});
  for (Submap& submap : blind.submaps) submap.points = {};
  const auto errors = mapErrors({{}, blind}, {}, {{}, {{}, {5, 0, 0}}});
  ASSERT_EQ(errors.size(), 2u);
  for (const MapError& error : errors) {
    EXPECT_EQ(error.error, 0);
    EXPECT_EQ(error.seen, 0);
  }
  EXPECT_TRUE(mapErrors({}, {}, {}).empty());
}

}  // namespace
}  // namespace roomgraph
