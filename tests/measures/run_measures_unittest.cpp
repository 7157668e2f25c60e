#include "run_measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

/** A run that has seen a square of 10 m free, as far as `seen` is left of it [m]. */
roomgraph::Run square(double seen) {
  roomgraph::Run run;
  run.map.frame = {100, 100, 0.1, {}};
  run.map.states.assign(run.map.frame.cellCount(), State::unknown);
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 10 * seen; ++x) run.map.states[run.map.frame.index({x, y})] = State::free;
  for (const Point corner : {Point{0, 0}, Point{10, 0}, Point{0, 10}, Point{10, 10}})
    run.map.walls.push_back({corner, {1, 0}});
  return run;
}

std::vector<MeasuredValue> coverage(const std::vector<roomgraph::Run>& runs,
                                    const std::vector<Transform2D>& poses, const PairBends& bends,
                                    Trust trust = {}) {
  Site site;
  for (const roomgraph::Run& run : runs) site.runs.push_back(&run);
  site.poses = poses;
  if (trust.empty()) trust.assign(runs.size(), 1);
  return coverageOf(site, DistinctMaps(bends), trust);
}

TEST(RunMeasures, whatHardlyTrustedRunsHaveSeenNobodyHasMissed) {
  const std::vector<roomgraph::Run> runs{square(5), square(5), square(10), square(10)};
  const PairBends bends(4);
  EXPECT_DOUBLE_EQ(*coverage(runs, {{}, {}, {}, {}}, bends)[0].value, 0.5);
  EXPECT_DOUBLE_EQ(*coverage(runs, {{}, {}, {}, {}}, bends, {1, 0.9, 1e-4, 1e-5})[0].value, 1);
  EXPECT_DOUBLE_EQ(*coverage(runs, {{}, {}, {}, {}}, bends, {1, 1e-4, 1e-4, 1e-4})[0].value, 0.5);
}

TEST(RunMeasures, coverageIsTheShareOfWhatTwoHaveSeen) {
  const std::vector<roomgraph::Run> runs{square(10), square(10), square(5)};
  const auto measures = coverage(runs, {{}, {}, {}}, PairBends(3));
  EXPECT_NEAR(measures[0].value.value(), 1, 1e-9);
  EXPECT_NEAR(measures[2].value.value(), 0.5, 0.02);
  EXPECT_NEAR(measures[2].high.value(), 1, 0.02) << "without one of the others";
}

TEST(RunMeasures, copiesThatArePlacedApartAreNoOtherWitnesses) {
  // Run 1 is a copy of run 0, and lies where runs 2 and 3 have seen something that run 0 has not.
  const std::vector<roomgraph::Run> runs{square(10), square(10), square(10), square(10)};
  PairBends bends(4);
  bends(0, 1).areIdentical = true;
  const auto measures = coverage(runs, {{}, {5, 0, 0}, {5, 0, 0}, {5, 0, 0}}, bends);
  EXPECT_NEAR(measures[0].value.value(), 0.5, 0.02);
  for (const std::size_t i : {1, 2, 3}) EXPECT_NEAR(measures[i].value.value(), 1, 1e-9) << i;
  for (const MeasuredValue& measure : measures) {
    EXPECT_GE(measure.low.value(), 0);
    EXPECT_LE(measure.high.value(), 1);
    EXPECT_LE(measure.low.value(), measure.value.value());
    EXPECT_GE(measure.high.value(), measure.value.value());
  }
}

/** Of run 0 against the others. */
MeasuredValue bendOfFirst(const PairBends& bends, const Trust& trust) {
  return bendOf(bends, DistinctMaps(bends), trust, 0);
}

TEST(RunMeasures, theBendOfARunIsItsMeanAgainstTheOthersByTrust) {
  PairBends bends(4);
  bends(0, 1) = {0.1, 1, 400}, bends(0, 2) = {0.3, 1, 500}, bends(0, 3) = {0.8, 1, 600};
  const MeasuredValue found = bendOfFirst(bends, {1, 1, 1, 0});
  EXPECT_NEAR(found.value.value(), 0.2, 1e-9) << "a run without trust has no say";
  EXPECT_EQ(found.support, 900);
  EXPECT_NEAR(found.low.value(), 0.1, 1e-9);
  EXPECT_NEAR(found.high.value(), 0.3, 1e-9);
  EXPECT_NEAR(bendOfFirst(bends, {1, 3, 1, 0}).value.value(), 0.15, 1e-9);
}

TEST(RunMeasures, aCopyOfARunIsNoOther) {
  PairBends bends(3);
  bends(0, 1) = {0, 1, 400, true}, bends(0, 2) = bends(1, 2) = {0.3, 1, 500};
  const MeasuredValue found = bendOfFirst(bends, {1, 1, 1});
  EXPECT_NEAR(found.value.value(), 0.3, 1e-9);
  EXPECT_FALSE(found.hasEnoughOthers);
}

TEST(RunMeasures, ofAPairTheBendIsTheirOwn) {
  EXPECT_EQ(bendOfPair({0.25, 0.8, 700}).value, 0.25);
  EXPECT_EQ(followedOfPair({0.25, 0.8, 700}).value, 0.8);
  EXPECT_EQ(followedOfPair({0.25, 0.8, 700}).support, 700);
  EXPECT_FALSE(bendOfPair({0, 0, 0}).value) << "nothing was found again";
}

TEST(RunMeasures, theAxisDeviationIsInDegrees) {
  roomgraph::Run run = square(10);
  EXPECT_FALSE(axisDeviationOf(run).value);
  run.map.axisDeviation = M_PI / 90;
  EXPECT_NEAR(axisDeviationOf(run).value.value(), 2, 1e-9);
  EXPECT_EQ(axisDeviationOf(run).support, 4) << "walls";
}

/** Distances of one map's walls from another's: so many of each. */
WallDistances distancesOf(double near, double far) {
  WallDistances distances;
  distances.count = near + far, distances.sum = 0.5 * far;
  distances.histogram[0] = near, distances.histogram[100] = far;  // 0 and half a metre
  return distances;
}

TEST(RunMeasures, wallDistancesAreThoseOfAllOthersTogether) {
  DistanceTable distances(3, pairsOf(3));
  distances(0, 1) = distancesOf(100, 0), distances(0, 2) = distancesOf(0, 100);
  const MeasuredValue p25 = wallDistanceOf(distances, {1, 1, 1}, 0, 0.25);
  EXPECT_NEAR(p25.value.value(), 0, 0.005);
  EXPECT_NEAR(p25.high.value(), 0.5, 0.005) << "without the near one";
  EXPECT_NEAR(wallDistanceOf(distances, {1, 1, 1}, 0, 0.9).value.value(), 0.5, 0.005);
  EXPECT_EQ(p25.support, 200);
}

TEST(RunMeasures, ofAPairTheWallsOfBothCount) {
  DistanceTable distances(2, pairsOf(2));
  distances(0, 1) = distancesOf(300, 0), distances(1, 0) = distancesOf(0, 100);
  EXPECT_NEAR(meanWallDistanceOfPair(distances, 0, 1).value.value(), 0.125, 1e-9);
  EXPECT_NEAR(wallDistanceOfPair(distances, 1, 0, 0.9).value.value(), 0.5, 0.005);
  EXPECT_FALSE(wallDistanceOfPair(DistanceTable(2, pairsOf(2)), 0, 1, 0.5).value) << "no walls";
}

TEST(RunMeasures, coverageIsThatOfPlainCounting) {
  // Runs that have seen stripes of different widths, at whole cells.
  const std::vector<double> widths{3, 7, 10, 5.5};
  std::vector<roomgraph::Run> runs;
  for (const double width : widths) runs.push_back(square(width));
  const std::vector<Transform2D> poses{{}, {2, 0, 0}, {-1, 0, 0}, {4, 0, 0}};
  const auto measures = coverage(runs, poses, PairBends(4));
  const auto sees = [&](std::size_t run, double x) {
    return x > poses[run].x && x < poses[run].x + widths[run];
  };
  double all = 0;
  std::vector<double> mine(4);
  for (double x = -1.95; x < 15; x += 0.1) {
    std::size_t count = 0;
    for (std::size_t run = 0; run < 4; ++run) count += sees(run, x);
    if (count < 2) continue;
    ++all;
    for (std::size_t run = 0; run < 4; ++run) mine[run] += sees(run, x);
  }
  for (std::size_t run = 0; run < 4; ++run)
    EXPECT_NEAR(measures[run].value.value(), mine[run] / all, 0.02) << run;
}

TEST(RunMeasures, withoutAPlaceThatTwoHaveSeenThereIsNoCoverage) {
  const std::vector<roomgraph::Run> runs{square(10), square(10)};
  for (const MeasuredValue& measure : coverage(runs, {{}, {50, 0, 0}}, PairBends(2)))
    EXPECT_FALSE(measure.value);
}

const WallMap& building() {
  static const WallMap map = wallMap(test::drawnBuilding(3, {}));
  return map;
}

TEST(WallDistances, ofAMapFromItselfAreNothing) {
  const WallDistances own = wallDistances(building(), building(), {});
  EXPECT_EQ(own.count, double(building().walls.size()));
  EXPECT_EQ(own.mean(), 0);
  EXPECT_EQ(own.quantile(0.9), 0);
}

TEST(WallDistances, growWithTheShift) {
  // Walls along the shift stay where they are: about half of all.
  const WallDistances near = wallDistances(building(), building(), {0.1, 0, 0});
  const WallDistances far = wallDistances(building(), building(), {0.3, 0, 0});
  EXPECT_GT(near.mean(), 0.02);
  EXPECT_GT(far.mean(), near.mean() + 0.05);
  EXPECT_LT(far.quantile(0.25), 0.1);
  EXPECT_GT(far.quantile(0.9), 0.25);
}

TEST(WallDistances, whatTheOtherHasNotSeenDoesNotCount) {
  const Grid half = test::drawnBuilding(3, {}, {-1e9, 12});
  const WallDistances both = wallDistances(building(), wallMap(half), {});
  EXPECT_LT(both.count, 0.7 * double(building().walls.size()));
  EXPECT_LT(both.quantile(0.5), 0.02);
  EXPECT_EQ(wallDistances(building(), building(), {500, 0, 0}).count, 0);
}

TEST(WallDistances, withoutPointsAreNothing) {
  EXPECT_EQ(WallDistances().mean(), 0);
  EXPECT_EQ(WallDistances().quantile(0.5), 0);
}

TEST(WallDistances, addUpByWeight) {
  WallDistances sum, other;
  other.sum = 3, other.count = 2, other.histogram[100] = 2;  // two points at half a metre
  sum.sum = 0, sum.count = 2, sum.histogram[0] = 2;
  sum.add(other, 3);
  EXPECT_DOUBLE_EQ(sum.count, 8);
  EXPECT_DOUBLE_EQ(sum.mean(), 9.0 / 8);
  EXPECT_DOUBLE_EQ(sum.quantile(0.2), 0);
  EXPECT_DOUBLE_EQ(sum.quantile(0.5), 0.5);
}

TEST(WallDistances, areThoseToTheNearestWallThatFacesTheSameWay) {
  const Transform2D pose{0.15, -0.1, 0.01};
  const WallDistances found = wallDistances(building(), building(), pose);
  // By plain search; the tables may name a wall that is a little farther.
  double sum = 0, count = 0;
  for (const WallPoint& wall : building().walls) {
    const Point at = pose(wall.place), normal = turned(wall.normal, pose.phi);
    const Cell cell = building().frame.cellAt(at);
    if (!building().frame.contains(cell) ||
        building().states[building().frame.index(cell)] == State::unknown)
      continue;
    double nearest = WallMap::kReach;
    for (const WallPoint& other : building().walls)
      if (dot(other.normal, normal) > 0.7) nearest = std::min(nearest, distance(other.place, at));
    sum += nearest, ++count;
  }
  EXPECT_NEAR(found.count, count, 0.01 * count);
  EXPECT_GE(found.mean(), sum / count - 0.01);
  EXPECT_NEAR(found.mean(), sum / count, 0.03);
}

TEST(WallDistances, theFramesOfTheMapsChangeNothing) {
  const Grid grid = test::drawnBuilding(3, {});
  Grid there = grid;
  there.frame.origin = there.frame.origin + Point{32, -16};
  const WallMap moved = wallMap(there);
  const WallDistances here = wallDistances(building(), building(), {0.2, 0.1, 0});
  const WallDistances other = wallDistances(building(), moved, {32.2, -15.9, 0});
  EXPECT_EQ(here.count, other.count);
  EXPECT_NEAR(here.sum, other.sum, 1e-3 * here.sum) << "but for what lies on a boundary of cells";
}

TEST(WallDistances, quantilesRiseAndTheHistogramHoldsAll) {
  const WallDistances found = wallDistances(building(), building(), {0.3, 0.2, 0.02});
  double last = 0, all = 0;
  for (const double share : {0.0, 0.25, 0.5, 0.75, 0.9, 1.0}) {
    const double value = found.quantile(share);
    EXPECT_GE(value, last) << share;
    EXPECT_LE(value, WallMap::kReach + WallDistances::kStep);
    last = value;
  }
  for (const double count : found.histogram) all += count;
  EXPECT_EQ(all, found.count);
}

TEST(WallDistances, aWallWithNoneInReachIsAsFarAsCanBe) {
  WallMap blank = building();
  for (auto& nearest : blank.nearest)
    nearest = {std::vector<std::uint32_t>(blank.frame.cellCount(), kNoIndex), kNoIndex};
  const WallDistances found = wallDistances(building(), blank, {0.01, 0, 0});
  EXPECT_DOUBLE_EQ(found.mean(), WallMap::kReach);
}

}  // namespace
}  // namespace roomgraph
