#include <gtest/gtest.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <cmath>

#include "clouds.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/read_recording.h"
#include "sampled_grid.h"

namespace roomgraph {
namespace {

using mrpt::poses::CPose3D;
using test::oneObservation;

class ReadDepthScan : public test::Clouds {};

TEST_F(ReadDepthScan, pointsOf3DRangeScansGiveTheRoom) {
  mrpt::obs::CObservation3DRangeScan scan;
  scan.sensorPose = sensor_;
  scan.hasPoints3D = true;
  scan.resizePoints3DVectors(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    scan.points3D_x[i] = points_[i].x;
    scan.points3D_y[i] = points_[i].y;
    scan.points3D_z[i] = points_[i].z;
  }
  expectRoom(load(oneObservation(test::streamed(scan))));
}

/** Looks along x from the middle at the wall at x = 2; its lower rows meet the floor before it. */
mrpt::obs::CObservation3DRangeScan wallSeen(bool isDepth) {
  mrpt::obs::CObservation3DRangeScan scan;
  constexpr int rows = 120, columns = 160;
  constexpr double focal = 100;
  scan.sensorPose = CPose3D(0, 0, 0.5, 0, 0, 0);
  scan.sensorLabel = "camera";
  scan.timestamp = mrpt::Clock::fromDouble(1.7e9);
  scan.hasRangeImage = true;
  scan.range_is_depth = isDepth;
  scan.rangeUnits = 1e-3f;
  scan.cameraParams.ncols = columns, scan.cameraParams.nrows = rows;
  scan.cameraParams.setIntrinsicParamsFromValues(focal, focal, columns / 2.0, rows / 2.0);
  scan.rangeImage_setSize(rows, columns);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const double down = (r - rows / 2) / focal, right = (c - columns / 2) / focal;
      const double depth = down > 0 ? std::min(2.0, 0.9 / down) : 2.0;
      const double range = depth * std::hypot(1, right, down);
      scan.rangeImage(r, c) = std::uint16_t((isDepth ? depth : range) * 1000);
    }
  return scan;
}

TEST_F(ReadDepthScan, depthImagesGiveTheWallsThatTheyShow) {
  for (const bool isDepth : {true, false}) {
    SCOPED_TRACE(isDepth);
    const GreyMap map = load(oneObservation(test::streamed(wallSeen(isDepth))));
    const Grid grid = binarize(map, {});
    const auto walls = test::occupiedPlaces(grid);
    for (const Point p : walls) EXPECT_NEAR(p.x, 2, 0.08);
    EXPECT_GT(walls.size(), 50u) << "3.2 m of wall are in view";
    EXPECT_TRUE(grid.isFree({1, 0}));
  }
}

TEST_F(ReadDepthScan, of3DRangeScansTimeAndLabelAreKnown) {
  auto scan = wallSeen(true);
  for (const bool hasPoints : {false, true}) {
    scan.hasPoints3D = hasPoints;
    if (hasPoints) scan.resizePoints3DVectors(7);
    const auto run =
        readRecording(dir_.write("run.simplemap", oneObservation(test::streamed(scan))));
    ASSERT_TRUE(run && run->times());
    EXPECT_NEAR(run->times()->first, 1.7e9, 1e-6);
    EXPECT_EQ(run->sensors.count({"CObservation3DRangeScan", 10, "camera"}), 1u);
  }
}

}  // namespace
}  // namespace roomgraph
