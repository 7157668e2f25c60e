#include "roomgraph/archive/record_files.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "roomgraph/base/Error.h"
#include "roomgraph/map_files/map_sha256.h"
#include "sample_nights.h"

namespace roomgraph {
namespace {

/** Maps in a folder, the first the oldest and the best. */
struct Maps {
  test::Folder folder;
  std::vector<HistoryRun> runs;
  std::vector<std::string> missing;

  explicit Maps(int count) {
    for (int i = 0; i < count; ++i) {
      HistoryRun run = test::historyRun("anna", i, 0.1 + 0.01 * i);
      run.file = folder.file("m" + std::to_string(i) + ".pgm");
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
  EXPECT_THROW(runTime(maps.folder.file("none.pgm")), std::exception);
}

std::string write(const std::string& file, const std::string& text) {
  std::filesystem::create_directories(std::filesystem::path(file).parent_path());
  std::ofstream(file) << text;
  return file;
}

TEST(KeepMap, aCopyOutlivesItsMap) {
  const test::Folder folder;
  const std::string map = write(folder.file("latest.pgm"), "P2 2 1 255 0 254");
  const std::string sha256 = mapSha256(map);
  const std::string kept = keepMap(map, sha256, folder.file("kept"));
  EXPECT_EQ(std::filesystem::path(kept).filename(), "latest.pgm");
  EXPECT_EQ(keepMap(map, sha256, folder.file("kept")), kept);
  write(map, "P2 2 1 255 254 254");
  EXPECT_EQ(mapSha256(kept), sha256);
  EXPECT_NE(keepMap(map, mapSha256(map), folder.file("kept")), kept);
}

TEST(KeepMap, thePictureOfARosMapIsKeptWithIt) {
  const test::Folder folder;
  write(folder.file("map.pgm"), "P2 2 1 255 0 254");
  const std::string yaml =
      write(folder.file("map.yaml"), "image: map.pgm\nresolution: 0.5\norigin: [0, 0, 0]\n");
  const std::string kept = keepMap(yaml, mapSha256(yaml), folder.file("kept"));
  std::filesystem::remove(folder.file("map.pgm"));
  EXPECT_NO_THROW(mapSha256(kept));
}

TEST(KeepMap, whatCannotBeKeptIsRefused) {
  const test::Folder folder;
  write(folder.file("map.pgm"), "P2 2 1 255 0 254");
  const std::string yaml = write(folder.file("deep/map.yaml"),
                                 "image: ../map.pgm\nresolution: 0.5\norigin: [0, 0, 0]\n");
  EXPECT_THROW(keepMap(yaml, mapSha256(yaml), folder.file("kept")), DataError);
  const std::string map = folder.file("map.pgm");
  EXPECT_THROW(keepMap(map, std::string(64, '0'), folder.file("kept")), DataError);
}

}  // namespace

}  // namespace roomgraph
