
#include <gtest/gtest.h>

#include <algorithm>

#include "roomgraph/evaluation/write_stability.h"
#include "small_experiment.h"

namespace roomgraph {
namespace {

using test::SmallExperiment;
using test::smallExperiment;

TEST(StabilityProgress, whatIsDoneNeedNotBeDoneAgainForTheSameBytes) {
  const SmallExperiment e = smallExperiment();
  const Stability whole = test::stability(e);
  const std::string key = stabilityKey(e.map.source, e.extract, e.options);
  RunsDone some(whole.runs.size());
  for (const std::size_t i : {0u, 3u, 6u}) some[i] = whole.measures[i];
  const RunsDone again = readProgress(progressText(key, whole.runs, some), key, whole.runs);
  const StabilityBase base = stabilityBase(e.map, e.extract, e.options);
  std::vector<RunMeasures> measures;
  for (std::size_t i = 0; i < again.size(); ++i) {
    EXPECT_EQ(again[i].has_value(), some[i].has_value()) << i;
    measures.push_back(again[i] ? *again[i] : measureRun(base, whole.runs[i]));
  }
  const Stability resumed = summarizeStability(e.map, base, e.options, measures);
  EXPECT_EQ(stabilityJson(resumed), stabilityJson(whole));
  EXPECT_EQ(stabilityCsv(resumed), stabilityCsv(whole));
}

TEST(StabilityProgress, keepsAllDigitsAndWhatIsMissing) {
  StabilityOptions options;
  options.repeats = 1;
  const auto runs = stabilityRuns(options);
  RunsDone done(runs.size());
  done[5] = RunMeasures{};
  done[5]->room.nearest = 1.0 / 3;
  done[5]->rooms = 17;
  const RunsDone read = readProgress(progressText("{}", runs, done), "{}", runs);
  ASSERT_TRUE(read[5]);
  EXPECT_EQ(read[5]->room.nearest, 1.0 / 3);
  EXPECT_FALSE(read[5]->noRoom.nearest);
  EXPECT_FALSE(read[5]->roomsFound);
  EXPECT_EQ(read[5]->rooms, 17);
}

TEST(StabilityProgress, countsForOtherListsOfTheSameExperiment) {
  StabilityOptions few, many;
  few.repeats = 1;
  const auto runs = stabilityRuns(few);
  const RunsDone done(runs.size(), RunMeasures{});
  const RunsDone read = readProgress(progressText("{}", runs, done), "{}", stabilityRuns(many));
  EXPECT_EQ(std::count_if(read.begin(), read.end(), [](const auto& r) { return bool(r); }), 20);
}

TEST(StabilityProgress, ofOtherInputsOrDamagedIsNone) {
  StabilityOptions options;
  const auto runs = stabilityRuns(options);
  const RunsDone done(runs.size(), RunMeasures{});
  const std::string text = progressText("{}", runs, done);
  const auto isNone = [&](const std::string& file, const std::string& key) {
    for (const auto& run : readProgress(file, key, runs))
      if (run) return false;
    return true;
  };
  EXPECT_FALSE(isNone(text, "{}"));
  EXPECT_TRUE(isNone(text, "{\"seed\":1}"));
  EXPECT_TRUE(isNone(text.substr(0, text.size() / 2), "{}"));
  EXPECT_TRUE(isNone("", "{}"));
  EXPECT_TRUE(isNone("{\"key\":{},\"runs\":[{\"distance\":\"x\"}]}", "{}"));
}

TEST(StabilityKey, dependsOnMapOptionsAndSeedButNotOnTheLists) {
  GreyMap::Source source;
  source.sha256 = "abc";
  ExtractOptions extract;
  StabilityOptions options;
  const std::string key = stabilityKey(source, extract, options);
  options.repeats = 3;
  options.percents = {50};
  EXPECT_EQ(stabilityKey(source, extract, options), key);
  options.seed = 2;
  EXPECT_NE(stabilityKey(source, extract, options), key);
  options.seed = 1;
  extract.findRooms.alphaPx2 = 200;
  EXPECT_NE(stabilityKey(source, extract, options), key);
  extract.findRooms.alphaPx2 = 0;
  source.sha256 = "abd";
  EXPECT_NE(stabilityKey(source, extract, options), key);
}

}  // namespace
}  // namespace roomgraph
