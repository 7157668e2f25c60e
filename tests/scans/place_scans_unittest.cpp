#include <gtest/gtest.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <algorithm>
#include <cmath>

#include "clouds.h"
#include "newer_simplemap.h"
#include "roomgraph/grid/binarize.h"
#include "sampled_grid.h"
#include "simplemap_entry.h"

namespace roomgraph {
namespace {

using mrpt::poses::CPose3D;
using test::cloudBytes;
using test::pointsMapBytes;

class PlaceScans : public test::Clouds {};

TEST_F(PlaceScans, cloudsOfARocking2DScannerAreTakenWhole) {
  std::vector<std::string> entries;
  for (const double roll : {-0.04, 0.0, 0.04}) {
    const CPose3D robot(0, 0, roll, 0.2, 0.02, roll);
    test::Points ring;  // on the walls, in the scanner's plane
    for (double a = 0; a < 2 * M_PI; a += 0.01) {
      const double range = 2 / std::max(std::abs(std::cos(a + 0.2)), std::abs(std::sin(a + 0.2)));
      ring.emplace_back(float(range * std::cos(a)), float(range * std::sin(a)), 0.f);
    }
    const std::string cloud = pointsMapBytes("mrpt::maps::CSimplePointsMap", 10, ring, "");
    entries.push_back(test::streamed(mrpt::poses::CPose3DPDFGaussian(robot)) +
                      test::frameBytes({cloudBytes({0, 0, 0.3, 0, 0, 0}, '\0' + cloud)}) +
                      test::twistBytes(false));
  }
  const GreyMap map = load(test::simplemapBytes(2, entries));
  expectRoom(map);
  EXPECT_NE(map.notes.at(0).text.find("one plane"), std::string::npos);
}

TEST_F(PlaceScans, theSliceCanBeSetAndIsNoted) {
  LoadGridOptions low;
  low.sliceLow = 0.1, low.sliceHigh = 0.5;
  const GreyMap map = load(inside(simple_), low);
  EXPECT_NE(map.notes[0].text.find("0.10 to 0.50 m above the floor"), std::string::npos)
      << map.notes[0].text;
  const auto isWall = [](const GreyMap& m, Point p) {
    const Grid grid = binarize(m, {});
    const Cell at = grid.frame.cellAt(p);
    for (int dx = -1; dx <= 1; ++dx)
      if (grid.atOrUnknown({at.x + dx, at.y}) == State::occupied) return true;
    return false;
  };
  EXPECT_TRUE(isWall(map, {1.5, 0})) << "the table";
  const GreyMap chosen = load(inside(simple_));
  EXPECT_FALSE(isWall(chosen, {1.5, 0})) << "the band above the table has more straight wall";
  EXPECT_TRUE(isWall(chosen, {2, 0}));
}

TEST_F(PlaceScans, scansGoBeforeCloudsUnlessASliceIsAskedFor) {
  auto simplemap = test::smallSimplemap();
  const GreyMap scans = load(test::streamed(simplemap));
  const auto [pose, frame] = test::entryOf(simplemap, 0);
  std::vector<std::string> entries;
  for (std::size_t i = 0; i < simplemap.size(); ++i)
    entries.push_back(test::streamed(*test::entryOf(simplemap, i).pose) +
                      test::frameBytes({test::streamed(**test::entryOf(simplemap, i).sf->begin()),
                                        cloudBytes(sensor_, std::string(1, '\0') + simple_)}) +
                      test::twistBytes(false));
  const std::string both = test::simplemapBytes(2, entries);
  const GreyMap map = load(both);
  EXPECT_EQ(map.grey, scans.grey);
  EXPECT_EQ(map.notes.at(0).code, "other_observations");
  LoadGridOptions options;
  options.sliceLow = 1, options.sliceHigh = 2;
  EXPECT_EQ(load(both, options).notes.at(0).code, "slice");
}

TEST_F(PlaceScans, keyframesOfCloudsAreTheirSlices) {
  const auto frames = loadMap(dir_.write("run.simplemap", inside(simple_)), {}).keyframes;
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_GT(frames[0].ends.size(), 300u);
  EXPECT_NEAR(*frames[0].time, 132e15 / 1e7 - 11644473600.0, 1e-3);
  EXPECT_EQ(frames[0].pose.x, 0);
  for (const Point end : frames[0].ends)
    EXPECT_NEAR(std::max(std::abs(end.x), std::abs(end.y)), 2, 0.05);
}

TEST(SlicedRun, hasTheWallsOfItsScans) {
  const std::string original = "/usr/share/mrpt/datasets/malaga-cs-fac-building.simplemap.gz";
  const std::string clouds = test::sharedFile("mrpt_new/v2_pointcloud_twist_zstd.simplemap");
  if (clouds.empty() || !test::isFile(original)) GTEST_SKIP() << "the run is not there";
  const Grid scans = binarize(loadGrid(original, {}), {}),
             sliced = binarize(loadGrid(clouds, {}), {});
  int near = 0;
  const auto walls = test::occupiedPlaces(sliced);
  for (const Point p : walls) {
    const Cell c = scans.frame.cellAt(p);
    bool isNear = false;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        isNear = isNear || scans.atOrUnknown({c.x + dx, c.y + dy}) == State::occupied;
    near += isNear;
  }
  EXPECT_GT(walls.size(), 5000u);
  EXPECT_GT(near, 0.95 * double(walls.size()));
}

}  // namespace
}  // namespace roomgraph
