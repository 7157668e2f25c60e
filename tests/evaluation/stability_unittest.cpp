#include "roomgraph/evaluation/stability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <thread>

#include "roomgraph/base/Error.h"
#include "roomgraph/evaluation/write_stability.h"
#include "roomgraph/measures/match_elements.h"
#include "small_experiment.h"

namespace roomgraph {
namespace {

using test::SmallExperiment;
using test::smallExperiment;

TEST(StabilityRuns, areTheTwoHundredOfThePaperEachWithItsOwnSeed) {
  const auto runs = stabilityRuns({});
  EXPECT_EQ(runs.size(), 200u);
  std::set<std::uint64_t> seeds;
  for (const StabilityRun& run : runs) seeds.insert(run.noise.seed);
  EXPECT_EQ(seeds.size(), 200u);
}

TEST(StabilityRuns, keepTheirSeedWhateverElseIsRun) {
  StabilityOptions one;
  one.distances = {3};
  one.percents = {8};
  one.repeats = 1;
  const auto all = stabilityRuns({});
  const auto same = std::find_if(all.begin(), all.end(), [](const StabilityRun& run) {
    return run.noise.maxDistance == 3 && run.noise.percent == 8 && run.repeat == 1;
  });
  ASSERT_NE(same, all.end());
  EXPECT_EQ(stabilityRuns(one).front().noise.seed, same->noise.seed);
  const std::uint64_t seed = stabilityRuns(one).front().noise.seed;
  one.seed = 2;
  EXPECT_NE(stabilityRuns(one).front().noise.seed, seed);
}

TEST(StabilityRuns, refuseWhatMakesNoSense) {
  const auto refuses = [](auto change) {
    StabilityOptions options;
    change(options);
    EXPECT_THROW(stabilityRuns(options), UsageError);
  };
  refuses([](auto& o) { o.distances = {}; });
  refuses([](auto& o) { o.distances = {0}; });
  refuses([](auto& o) { o.distances = {3, 3}; });
  refuses([](auto& o) { o.percents = {101}; });
  refuses([](auto& o) { o.percents = {std::nan("")}; });
  refuses([](auto& o) { o.repeats = 0; });
}

TEST(Stability, isPerfectWhereTheNoiseMovesNothing) {
  SmallExperiment e = smallExperiment();
  e.options.percents = {0};
  e.options.basePercent = 0;
  const Stability result = test::stability(e);
  ASSERT_EQ(result.rows.size(), 2u);
  for (const StabilityRow& row : result.rows) {
    EXPECT_EQ(row.room.nearest, 0.0);
    EXPECT_EQ(row.noRoom.nearest, 0.0);
    EXPECT_FALSE(row.ratio) << "0 / 0";
    EXPECT_EQ(row.room.agreement.unmatchedBase, 0.0);
    EXPECT_EQ(row.noRoom.agreement.unmatchedOther, 0.0);
    EXPECT_EQ(row.roomsFound, 1.0);
    EXPECT_EQ(row.roomsChange, 0.0);
  }
  EXPECT_EQ(result.baseRooms, 6u);
}

TEST(Stability, comparesWithOneNoisyMapByThePapersMeasure) {
  const SmallExperiment e = smallExperiment();
  const StabilityBase base = stabilityBase(e.map, e.extract, e.options);
  const StabilityRun run = stabilityRuns(e.options).back();
  const RunMeasures measures = measureRun(base, run);
  // The same noise by hand, given as a map of two greys: the office has no unknown cell.
  GreyMap noisy = e.map;
  const Grid grid = addWallNoise(binarize(e.map, e.extract.binarize), run.noise);
  for (std::size_t i = 0; i < noisy.grey.size(); ++i)
    noisy.grey[i] = grid.cells[i] == State::occupied ? 0 : 255;
  const Stages stages = extract(noisy, e.extract);
  EXPECT_EQ(measures.room.nearest, nearestVertices(base.room.graph, stages.result.graph));
  EXPECT_EQ(measures.noRoom.nearest, nearestVertices(base.noRoom, stages.kept));
  EXPECT_EQ(measures.rooms, int(stages.result.rooms.size()));
  EXPECT_GT(measures.noRoom.nearest, 0.0);
}

TEST(Stability, isTheSameOnAnyNumberOfThreads) {
  const SmallExperiment e = smallExperiment();
  const Stability alone = test::stability(e);
  const StabilityBase base = stabilityBase(e.map, e.extract, e.options);
  const auto runs = stabilityRuns(e.options);
  std::vector<RunMeasures> measures(runs.size());
  std::vector<std::thread> threads;
  for (std::size_t i = runs.size(); i-- > 0;)
    threads.emplace_back([&, i] { measures[i] = measureRun(base, runs[i]); });
  for (std::thread& thread : threads) thread.join();
  const Stability together = summarizeStability(e.map, base, e.options, measures);
  EXPECT_EQ(stabilityJson(alone), stabilityJson(together));
  EXPECT_EQ(stabilityCsv(alone), stabilityCsv(together));
}

TEST(Stability, rowsAreMeansOfTheirRepeatsAndTheMeanRatioIsThatOfTheRows) {
  const SmallExperiment e = smallExperiment();
  const StabilityBase base = stabilityBase(e.map, e.extract, e.options);
  std::vector<RunMeasures> measures(8);
  for (std::size_t i = 0; i < measures.size(); ++i) {
    measures[i].room.nearest = double(i);
    measures[i].noRoom.nearest = 10.0;
    measures[i].rooms = int(base.room.rooms.size()) + (i % 2 ? -1 : 1);
  }
  Stability result = summarizeStability(e.map, base, e.options, measures);
  EXPECT_DOUBLE_EQ(result.rows[1].room.nearest.value(), 2.5);
  EXPECT_DOUBLE_EQ(result.rows[1].ratio.value(), 0.25);
  EXPECT_DOUBLE_EQ(result.rows[1].roomsChange, 1);
  EXPECT_DOUBLE_EQ(result.mean.ratio.value(), 0.35);
  EXPECT_EQ(result.rows[1].distance, 1);
  EXPECT_EQ(result.rows[1].percent, 8);
  // One noisy map without a graph: its row has no number, rather than one that hides it.
  measures[2].room.nearest.reset();
  result = summarizeStability(e.map, base, e.options, measures);
  EXPECT_FALSE(result.rows[1].ratio);
  EXPECT_FALSE(result.mean.ratio);
  EXPECT_TRUE(result.rows[0].ratio);
}

TEST(Stability, mapsWithoutAGraphHaveNoNumbers) {
  GreyMap map;
  map.frame = {20, 20, 0.1, {}};
  map.grey.assign(400, 0);
  StabilityOptions options;
  options.repeats = 1;
  options.distances = {1};
  const Stability result = test::stability({map, {}, options});
  EXPECT_FALSE(result.mean.ratio);
  EXPECT_FALSE(result.mean.roomsFound);
  EXPECT_EQ(result.baseRooms, 0u);
}

}  // namespace
}  // namespace roomgraph
