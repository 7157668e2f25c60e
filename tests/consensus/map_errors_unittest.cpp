#include "roomgraph/consensus/map_errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "RandomNumbers.h"
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

TEST(MapErrors, whatIsLostCountsAsAMetreOff) {
  const Way truth = roundTheBlock(), drawn = test::drifting(truth, 0.01);
  const std::vector<RunSubmaps> runs{drawnSubmaps(drawn)};
  const MapError before = mapErrors(runs, {}, {truth})[0];
  std::vector<bool> isLost(truth.size());
  MapError error = before;
  addLost(error, runs[0], isLost);
  EXPECT_EQ(error.error, before.error);
  EXPECT_EQ(error.high, before.high);
  for (const std::size_t k : {3u, 4u, 5u}) isLost[k] = true;
  addLost(error, runs[0], isLost);
  const double more = std::sqrt(3.0 / double(truth.size()));
  EXPECT_NEAR(error.error, std::hypot(before.error, more), 1e-9);
  EXPECT_EQ(error.low, before.low);
  EXPECT_GT(error.high - error.error, before.high - before.error);
  for (std::size_t k = 0; k < truth.size(); ++k)
    EXPECT_EQ(error.errors[k], isLost[k] ? std::hypot(before.errors[k], 1) : before.errors[k]);
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

/** A run whose submaps have drawn points of their own, anywhere. */
struct AnyRun {
  std::vector<std::vector<Point>> points;
  RunSubmaps run;
  std::vector<Transform2D> poses;  // where they really lie

  explicit AnyRun(std::uint32_t seed) {
    test::RandomNumbers random(seed);
    run.areScans = true;
    for (int k = 0; k < 12; ++k) {
      run.submaps.push_back({random.pose(10), {}, std::nullopt});
      poses.push_back(run.submaps.back().pose * random.pose(1));
      points.emplace_back();
      for (std::size_t i = random.below(6); i > 0; --i) {
        points.back().push_back(random.place(4));
        run.submaps.back().points.add(points.back().back());
      }
    }
  }

  /** Mean squared distance of all points after a motion, the slow way. */
  double meanSquare(const Transform2D& motion) const {
    double squares = 0, count = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
      for (const Point p : points[k])
        squares += squaredNorm(motion(run.submaps[k].pose(p)) - poses[k](p)), ++count;
    return squares / count;
  }
};

TEST(MapErrors, noOtherMotionLeavesLessOver) {
  for (const std::uint32_t seed : {1u, 2u, 3u, 4u}) {
    const AnyRun any(seed);
    const MapError error = mapErrors({any.run}, {}, {any.poses})[0];
    const double best = any.meanSquare(error.pose);
    EXPECT_NEAR(error.error, std::sqrt(best), 1e-9);
    for (const Transform2D& nudge :
         {Transform2D{0.01, 0, 0}, Transform2D{0, 0.01, 0}, Transform2D{0, 0, 0.01},
          Transform2D{-0.01, 0.02, -0.01}, Transform2D{1, 2, 3}})
      EXPECT_GT(any.meanSquare(nudge * error.pose), best) << seed;
  }
}

TEST(MapErrors, thoseOfSubmapsAreThoseOfTheirPoints) {
  const AnyRun any(7);
  const MapError error = mapErrors({any.run}, {}, {any.poses})[0];
  for (std::size_t k = 0; k < any.points.size(); ++k) {
    if (any.points[k].empty()) continue;
    double squares = 0;
    for (const Point p : any.points[k])
      squares += squaredNorm(error.pose(any.run.submaps[k].pose(p)) - any.poses[k](p));
    EXPECT_NEAR(error.errors[k], std::sqrt(squares / double(any.points[k].size())), 1e-9) << k;
  }
}

TEST(MapErrors, areThoseOfTheRunsInAnyOrder) {
  const Way truth = roundTheBlock();
  std::vector<RunSubmaps> runs{drawnSubmaps(test::drifting(truth, 0.01)), drawnSubmaps(truth),
                               drawnSubmaps(test::torn(truth, 20, 1, {}))};
  std::vector<RunMatches> matches = test::exactMatches({truth, truth, truth});
  matches.erase(matches.begin());
  for (RunMatches& pair : matches) pair.matches.resize(pair.of == 2 ? 5 : 20);
  const SubmapPoses poses{truth, truth, truth};
  const auto before = mapErrors(runs, matches, poses);
  std::reverse(runs.begin(), runs.end());
  for (RunMatches& pair : matches) pair.of = 2 - pair.of, pair.in = 2 - pair.in;
  const auto after = mapErrors(runs, matches, poses);
  for (std::size_t r = 0; r < 3; ++r) {
    EXPECT_EQ(after[2 - r].error, before[r].error);
    EXPECT_EQ(after[2 - r].high, before[r].high);
    EXPECT_EQ(after[2 - r].isSeen, before[r].isSeen);
  }
}

}  // namespace
}  // namespace roomgraph
