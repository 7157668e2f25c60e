#include "roomgraph/relate/join_drives.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_building.h"
#include "drawn_drive.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {
namespace {

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
