#include "roomgraph/relate/shared_drives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "RandomNumbers.h"
#include "drawn_building.h"
#include "drawn_drive.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {
namespace {

using Sets = std::vector<std::vector<std::size_t>>;

/** A run over the scans `first` to `last` of a log. */
roomgraph::Run over(std::uint64_t first, std::uint64_t last) {
  roomgraph::Run run;
  for (std::uint64_t id = first; id <= last; ++id) {
    run.scans.emplace_back();
    run.scans.back().scanId = id;
    run.scans.back().ends.add({1, 1});
  }
  return run;
}

Sets drivesOf(const std::vector<roomgraph::Run>& runs) {
  std::vector<const roomgraph::Run*> pointers;
  for (const roomgraph::Run& run : runs) pointers.push_back(&run);
  return sharedDrives(pointers);
}

TEST(SharedDrives, runsOverOneLogAreOfOneDrive) {
  EXPECT_EQ(drivesOf({over(1, 50), over(100, 150), over(1, 50)}), (Sets{{0, 2}}));
  EXPECT_EQ(drivesOf({over(1, 50), over(35, 85), over(70, 120)}), (Sets{{0, 1, 2}}))
      << "by way of the second";
  EXPECT_EQ(drivesOf({over(1, 9), over(50, 60), over(1, 9), over(52, 60)}), (Sets{{0, 2}, {1, 3}}));
}

TEST(SharedDrives, aFewScansInCommonAreNone) {
  EXPECT_TRUE(drivesOf({over(1, 50), over(45, 100)}).empty());
  EXPECT_TRUE(drivesOf({over(1, 50), {}, {}}).empty()) << "runs without scans";
  EXPECT_TRUE(drivesOf({}).empty());
}

TEST(SharedDrives, aFifthOfTheShorterRunIsTheLimit) {
  EXPECT_TRUE(drivesOf({over(1, 50), over(41, 140)}).empty()) << "10 of 50";
  EXPECT_EQ(drivesOf({over(1, 50), over(40, 139)}), (Sets{{0, 1}})) << "11 of 50";
  EXPECT_EQ(drivesOf({over(1, 500), over(495, 500)}), (Sets{{0, 1}})) << "all of a short one";
}

TEST(SharedDrives, blindScansAreNotSharedOnes) {
  roomgraph::Run a = over(1, 50), b = over(1, 50);
  for (ScanWalls& scan : b.scans) scan.ends = {};
  EXPECT_TRUE(drivesOf({a, b}).empty());
}

TEST(SharedDrives, areThoseOfPlainCounting) {
  test::RandomNumbers random(8);
  for (int trial = 0; trial < 60; ++trial) {
    const std::size_t count = 2 + random.below(7);
    std::vector<roomgraph::Run> runs;
    std::vector<std::set<std::uint64_t>> scans;
    for (std::size_t r = 0; r < count; ++r) {
      const std::uint64_t first = 1 + random.below(120), last = first + random.below(60);
      runs.push_back(over(first, last));
      scans.emplace_back();
      for (std::uint64_t id = first; id <= last; ++id) scans.back().insert(id);
    }
    // Which two share a drive, and by way of others: the closure of the pairs.
    std::vector<std::vector<bool>> share(count, std::vector<bool>(count));
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j) {
        std::size_t same = 0;
        for (const std::uint64_t id : scans[i]) same += scans[j].count(id);
        share[i][j] = 5 * same > std::min(scans[i].size(), scans[j].size());
      }
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j)
          if (share[i][k] && share[k][j]) share[i][j] = true;
    Sets expected;
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<std::size_t> set;
      for (std::size_t j = 0; j < count; ++j)
        if (share[i][j]) set.push_back(j);
      if (set.size() > 1 && set.front() == i) expected.push_back(set);
    }
    EXPECT_EQ(drivesOf(runs), expected) << trial;
  }
}

roomgraph::Run runOf(const std::vector<Keyframe>& frames) {
  roomgraph::Run run;
  run.map = wallMap(test::mapDrawnBy(frames));
  run.scans = scanWalls(frames);
  for (std::size_t i = 0; i < run.scans.size(); ++i) run.scans[i].scanId = i + 1;
  return run;
}

const std::vector<Keyframe>& drive() {
  static const auto frames = test::drawnDrive(test::drawnBuilding(4, {}));
  return frames;
}

const Transform2D kMoved{3, -2, 0.7};

/** Two runs of one drive, the second one broken in its middle, that were not found in each other,
 *  and one without scans. */
struct Apart {
  std::vector<roomgraph::Run> runs{
      runOf(drive()),
      runOf(test::moved(test::broken(drive(), drive().size() * 2 / 3, 0.5, {1, 1}), kMoved)),
      runOf(drive())};
  MapPairs related{3};

  Apart() { runs[2].scans.clear(); }
};

TEST(JoinDrives, runsWithTheSameScansLieAsTheseDo) {
  Apart apart;
  joinDrives(apart.related, apart.runs, oneByOne);
  const MapPair& pair = apart.related(0, 1);
  EXPECT_TRUE(isJoined(pair));
  EXPECT_EQ(pair.alignment.confidence, 1);
  const Point start = drive().front().pose.shift();
  EXPECT_LT(distance(pair.alignment.pose(kMoved(start)), start), 1)
      << "two thirds of it lie where they belong";
  EXPECT_GT(pair.bInA.share, 0.5);
}

TEST(JoinDrives, othersAreLeftAsTheyAre) {
  Apart apart;
  apart.related(0, 1).alignment.isSameSite = true;
  apart.related(0, 1).alignment.confidence = 0.7;
  joinDrives(apart.related, apart.runs, oneByOne);
  EXPECT_EQ(apart.related(0, 1).alignment.confidence, 0.7) << "they are joined already";
  EXPECT_FALSE(isJoined(apart.related(0, 2))) << "one has no scans";
  for (ScanWalls& scan : apart.runs[1].scans) scan.scanId += 10'000;
  apart.related(0, 1) = {};
  joinDrives(apart.related, apart.runs, oneByOne);
  EXPECT_FALSE(isJoined(apart.related(0, 1))) << "another drive";
}

}  // namespace
}  // namespace roomgraph
