#include "roomgraph/archive/record_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>

#include "RandomNumbers.h"
#include "TestFolder.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/map_files/map_sha256.h"
#include "sample_nights.h"

namespace roomgraph {
namespace {

/** Maps in a folder, the first the oldest and the best. */
struct Maps {
  TestFolder folder;
  std::vector<HistoryRun> runs;
  std::vector<std::string> missing;

  explicit Maps(int count) {
    for (int i = 0; i < count; ++i) {
      HistoryRun run = test::historyRun("anna", i, 0.1 + 0.01 * i);
      run.file = folder / ("m" + std::to_string(i) + ".pgm");
      write(run.file, i);
      run.sha256 = mapSha256(run.file);
      run.time = i;
      runs.push_back(run);
    }
  }
  static void write(const std::string& file, int shade) {
    std::ofstream(file) << "P2 2 1 255\n254 " << shade << "\n";
  }
  /** The times of the chosen ones, which are their numbers. */
  std::vector<double> chosen(std::size_t most) {
    missing.clear();
    std::vector<double> times;
    for (const HistoryRun& run :
         recordRuns(runs, most, [&](const HistoryRun& gone) { missing.push_back(gone.file); }))
      times.push_back(run.time);
    return times;
  }
};

using Times = std::vector<double>;

TEST(RecordRuns, areTheLatestAndTheBestWhoseFilesAreThere) {
  Maps maps(12);
  EXPECT_EQ(maps.chosen(4), (Times{0, 1, 10, 11}));
  EXPECT_TRUE(maps.missing.empty());
}

TEST(RecordRuns, aFileThatIsGoneIsToldAndAnotherTakesItsPlace) {
  Maps maps(12);
  std::filesystem::remove(maps.runs[11].file);
  std::filesystem::remove(maps.runs[0].file);
  EXPECT_EQ(maps.chosen(4), (Times{1, 2, 9, 10}));
  EXPECT_EQ(maps.missing, (std::vector<std::string>{maps.runs[11].file, maps.runs[0].file}));
}

TEST(RecordRuns, aFileThatHoldsAnotherMapNowIsNone) {
  Maps maps(6);
  Maps::write(maps.runs[5].file, 99);
  EXPECT_EQ(maps.chosen(2), (Times{0, 4}));
  EXPECT_EQ(maps.missing, (std::vector<std::string>{maps.runs[5].file}));
  std::ofstream(maps.runs[4].file) << "no map at all";
  EXPECT_EQ(maps.chosen(2), (Times{0, 3}));
}

TEST(RecordRuns, noFileIsAskedForWithoutNeed) {
  Maps maps(8);
  for (const std::size_t i : {2u, 3u, 4u, 5u}) std::filesystem::remove(maps.runs[i].file);
  EXPECT_EQ(maps.chosen(4), (Times{0, 1, 6, 7}));
  EXPECT_TRUE(maps.missing.empty()) << "none of those was needed";
}

TEST(RecordRuns, ofNoRunsThereAreNone) {
  Maps maps(0);
  EXPECT_TRUE(maps.chosen(8).empty());
}

TEST(RunTime, withoutScansIsThatOfTheFile) {
  const Maps maps(1);
  const auto hourAgo = std::filesystem::file_time_type::clock::now() - std::chrono::hours(1);
  std::filesystem::last_write_time(maps.runs[0].file, hourAgo);
  const double now = double(std::chrono::duration_cast<std::chrono::seconds>(
                                std::chrono::system_clock::now().time_since_epoch())
                                .count());
  EXPECT_NEAR(runTime(maps.runs[0].file), now - 3600, 5);
  EXPECT_THROW(runTime(maps.folder / "none.pgm"), std::exception);
}

TEST(KeepMap, aCopyOutlivesItsMap) {
  const TestFolder folder;
  const std::string map = folder.write("latest.pgm", "P2 2 1 255 0 254");
  const std::string sha256 = mapSha256(map);
  const std::string kept = keepMap(map, sha256, folder / "kept");
  EXPECT_EQ(std::filesystem::path(kept).filename(), "latest.pgm");
  EXPECT_EQ(keepMap(map, sha256, folder / "kept"), kept);
  folder.write("latest.pgm", "P2 2 1 255 254 254");
  EXPECT_EQ(mapSha256(kept), sha256);
  EXPECT_NE(keepMap(map, mapSha256(map), folder / "kept"), kept);
}

TEST(KeepMap, thePictureOfARosMapIsKeptWithIt) {
  const TestFolder folder;
  folder.write("map.pgm", "P2 2 1 255 0 254");
  const std::string yaml =
      folder.write("map.yaml", "image: map.pgm\nresolution: 0.5\norigin: [0, 0, 0]\n");
  const std::string kept = keepMap(yaml, mapSha256(yaml), folder / "kept");
  std::filesystem::remove(folder / "map.pgm");
  EXPECT_NO_THROW(mapSha256(kept));
}

TEST(KeepMap, whatCannotBeKeptIsRefused) {
  const TestFolder folder;
  folder.write("map.pgm", "P2 2 1 255 0 254");
  std::filesystem::create_directories(folder / "deep");
  const std::string yaml =
      folder.write("deep/map.yaml", "image: ../map.pgm\nresolution: 0.5\norigin: [0, 0, 0]\n");
  EXPECT_THROW(keepMap(yaml, mapSha256(yaml), folder / "kept"), DataError);
  const std::string map = folder / "map.pgm";
  EXPECT_THROW(keepMap(map, std::string(64, '0'), folder / "kept"), DataError);
}

using Indices = std::vector<std::size_t>;

bool any(const HistoryRun&) { return true; }

/** Runs of falling quality: the first is the best. */
std::vector<HistoryRun> runs(std::size_t count) {
  std::vector<HistoryRun> result;
  for (std::size_t i = 0; i < count; ++i)
    result.push_back(test::historyRun("", int(i), 0.1 + 0.01 * double(i)));
  return result;
}

void tear(HistoryRun& run) {
  Measure breaks;
  breaks.name = kBreaks, breaks.value = 1;
  run.figures.push_back(breaks);
}

bool isTorn(const HistoryRun& run) { return run.figures.back().name == kBreaks; }

TEST(ChooseRecord, halfAreTheLatestAndHalfTheBest) {
  EXPECT_EQ(chooseRecord(runs(50), 8, any), (Indices{0, 1, 2, 3, 46, 47, 48, 49}));
}

TEST(ChooseRecord, fewRunsAreAllChosenOnce) {
  EXPECT_EQ(chooseRecord({}, 8, any), Indices{});
  EXPECT_EQ(chooseRecord(runs(3), 8, any), (Indices{0, 1, 2}));
  EXPECT_EQ(chooseRecord(runs(8), 8, any), (Indices{0, 1, 2, 3, 4, 5, 6, 7}));
}

TEST(ChooseRecord, theBestAreAmongTheLastHundred) {
  EXPECT_EQ(chooseRecord(runs(200), 4, any), (Indices{100, 101, 198, 199}));
}

TEST(ChooseRecord, tornAndUnsureRunsAreNotAmongTheBest) {
  std::vector<HistoryRun> some = runs(20);
  tear(some[0]);
  some[1].figures[0].isMeaningful = false;
  EXPECT_EQ(chooseRecord(some, 4, any), (Indices{2, 3, 18, 19}));
  for (HistoryRun& run : some) run.figures[0].isMeaningful = false;
  EXPECT_EQ(chooseRecord(some, 4, any), (Indices{16, 17, 18, 19}));
}

TEST(ChooseRecord, runsOfAnotherSiteAreNeverOnceAnotherHasComeSince) {
  std::vector<HistoryRun> some = runs(6);
  some[4].isPlaced = some[0].isPlaced = false;
  EXPECT_EQ(chooseRecord(some, 8, any), (Indices{1, 2, 3, 5}));
}

TEST(ChooseRecord, upToAThirdAreTheLatestThatLieElsewhere) {
  std::vector<HistoryRun> some = runs(20);
  for (std::size_t i = 15; i < 20; ++i) some[i].isPlaced = false;
  EXPECT_EQ(chooseRecord(some, 8, any), (Indices{0, 1, 2, 13, 14, 17, 18, 19}));
  some[19].isPlaced = true;
  EXPECT_EQ(chooseRecord(some, 8, any), (Indices{0, 1, 2, 3, 12, 13, 14, 19}));
}

TEST(ChooseRecord, aWrongFirstMapMayHaveTheLatestTime) {
  std::vector<HistoryRun> some = runs(4);
  for (std::size_t i = 0; i < 3; ++i) some[i].isPlaced = false;
  EXPECT_EQ(chooseRecord(some, 8, any), (Indices{0, 1, 2, 3}));
  some[0].isPlaced = some[1].isPlaced = true;
  EXPECT_EQ(chooseRecord(some, 8, any), (Indices{0, 1, 3})) << "one is fewer than the site has";
}

TEST(ChooseRecord, noMoreThanAHundredFilesAreAskedFor) {
  std::size_t asked = 0;
  const auto isThere = [&](const HistoryRun&) { return ++asked == 0; };
  EXPECT_EQ(chooseRecord(runs(1000), 8, isThere), Indices{});
  EXPECT_EQ(asked, 100U);
}

TEST(ChooseRecord, othersTakeThePlaceOfRunsWhoseFilesAreGone) {
  std::vector<std::string> asked;
  const auto isThere = [&](const HistoryRun& run) {
    asked.push_back(run.sha256);
    return run.sha256 != "49" && run.sha256 != "0";
  };
  EXPECT_EQ(chooseRecord(runs(50), 4, isThere), (Indices{1, 2, 47, 48}));
  EXPECT_EQ(asked, (std::vector<std::string>{"49", "48", "47", "0", "1", "2"}));
}

/** Runs at random: some torn, some of another site, some without an error that can be trusted. */
std::vector<HistoryRun> anyRuns(test::RandomNumbers& random, std::size_t count) {
  std::vector<HistoryRun> any = runs(count);
  for (HistoryRun& run : any) {
    run.figures[0].value = double(random.below(20)) / 20;
    run.figures[0].isMeaningful = random.below(4) > 0;
    run.isPlaced = random.below(5) > 0;
    if (random.below(5) == 0) tear(run);
  }
  return any;
}

TEST(ChooseRecord, isWhatItsSentenceSays) {
  test::RandomNumbers random(6);
  for (int trial = 0; trial < 200; ++trial) {
    const std::vector<HistoryRun> some = anyRuns(random, random.below(160));
    const std::size_t most = 1 + random.below(12);
    const auto isUsable = [](const HistoryRun& run) { return run.sha256.back() != '3'; };
    Indices last, since;  // of the site, and of others since its last run, the latest first
    for (std::size_t i = some.size(); i-- > 0 && last.size() < 100;) {
      if (some[i].isPlaced) last.push_back(i);
      if (last.empty()) since.push_back(i);
    }
    Indices expected;
    const auto take = [&](std::size_t i, std::size_t upTo) {
      const bool isNew = std::find(expected.begin(), expected.end(), i) == expected.end();
      if (isNew && isUsable(some[i]) && expected.size() < upTo) expected.push_back(i);
    };
    for (const std::size_t i : since) take(i, (most + 2) / 3);
    const std::size_t half = (expected.size() + most) / 2;
    for (const std::size_t i : last) take(i, half);
    Indices best;
    for (const std::size_t i : last)
      if (some[i].figures[0].isMeaningful && !isTorn(some[i])) best.push_back(i);
    std::stable_sort(best.begin(), best.end(), [&](std::size_t l, std::size_t r) {
      return *some[l].figures[0].value < *some[r].figures[0].value;
    });
    for (const std::size_t i : best) take(i, most);
    for (const std::size_t i : last) take(i, most);
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(chooseRecord(some, most, isUsable), expected) << trial;
  }
}

TEST(ChooseRecord, ofNoneNoneIsChosen) { EXPECT_TRUE(chooseRecord(runs(9), 0, any).empty()); }

}  // namespace
}  // namespace roomgraph
