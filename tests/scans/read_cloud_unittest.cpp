#include <gtest/gtest.h>
#include <mrpt/maps/CColouredPointsMap.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/maps/CWeightedPointsMap.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <cmath>
#include <filesystem>

#include "drawn_cloud.h"
#include "map_files.h"
#include "newer_simplemap.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/scans/load_keyframes.h"
#include "roomgraph/scans/load_run_info.h"
#include "simplemap_entry.h"

namespace roomgraph {
namespace {

using mrpt::poses::CPose3D;
using test::cloudBytes;
using test::oneObservation;
using test::pointsMapBytes;

class Clouds : public testing::Test {
 protected:
  GreyMap load(const std::string& bytes, const LoadGridOptions& options = {}) const {
    return loadGrid(dir_.write("run.simplemap", bytes), options);
  }
  std::string errorOf(const std::string& bytes) const {
    try {
      load(bytes);
      return {};
    } catch (const DataError& error) {
      return error.what();
    }
  }
  /** The four walls of the room are in the map, within a cell, and little else. */
  static void expectRoom(const GreyMap& map) {
    const Grid grid = binarize(map, {});
    int walls = 0, strays = 0;
    for (int y = 0; y < grid.frame.height; ++y)
      for (int x = 0; x < grid.frame.width; ++x) {
        if (grid.at({x, y}) != State::occupied) continue;
        const Point p = grid.frame.center({x, y});
        const bool isWall = std::abs(std::max(std::abs(p.x), std::abs(p.y)) - 2) < 0.08;
        ++(isWall ? walls : strays);
      }
    EXPECT_GT(walls, 250);
    EXPECT_LT(strays, walls / 20);
    EXPECT_TRUE(grid.isFree({0.5, 0.4}));
    ASSERT_FALSE(map.notes.empty());
    EXPECT_EQ(map.notes[0].code, "slice");
  }
  std::string inside(const std::string& pointsMap) const {
    return oneObservation(cloudBytes(sensor_, std::string(1, '\0') + pointsMap));
  }
  std::string outside(char storage, const std::string& file) const {
    return oneObservation(cloudBytes(
        sensor_, std::string(1, storage) + test::raw(std::uint32_t(file.size())) + file));
  }
  void writeBeside(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories(dir_.path("run_Images"));
    dir_.write("run_Images/" + name, bytes);
  }

  const test::TempDir dir_;
  const CPose3D sensor_{0.3, -0.2, 0.5, 0.7, 0.05, -0.02};
  const test::Points points_ = test::seenFrom(sensor_, test::roomPoints());
  const std::string simple_ =
      pointsMapBytes("mrpt::maps::CSimplePointsMap", 10, points_, std::string(30, '\x88'));
};

TEST_F(Clouds, everyClassOfPointsGivesTheRoom) {
  mrpt::maps::CSimplePointsMap simple;
  mrpt::maps::CPointsMapXYZI intensity;
  mrpt::maps::CColouredPointsMap coloured;
  mrpt::maps::CWeightedPointsMap weighted;
  const std::initializer_list<mrpt::maps::CPointsMap*> maps{&simple, &intensity, &coloured,
                                                            &weighted};
  for (mrpt::maps::CPointsMap* map : maps) {
    for (const auto& p : points_) map->insertPoint(p.x, p.y, p.z);
    SCOPED_TRACE(map->GetRuntimeClass()->className);
    expectRoom(load(inside(test::streamed(*map))));
  }
}

TEST_F(Clouds, classesThatThisMrptDoesNotHaveGiveTheRoom) {
  // What is behind the points is not looked at.
  const std::string intensities(points_.size() * 4, '\x3f');
  expectRoom(load(inside(pointsMapBytes("mrpt::maps::CPointsMapXYZIRT", 0, points_, intensities))));
  for (const int version : {3, 4})
    expectRoom(load(inside(pointsMapBytes("mrpt::maps::CGenericPointsMap", version, points_,
                                          test::raw<std::uint32_t>(1) + intensities))));
}

TEST_F(Clouds, cloudsOfARocking2DScannerAreTakenWhole) {
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

TEST_F(Clouds, cloudsInFilesBesideTheMapAreRead) {
  writeBeside("a.bin", test::gzipped(simple_));
  expectRoom(load(outside(3, "a.bin")));
  writeBeside("a.bin", test::zstd(simple_, false));
  expectRoom(load(outside(3, "a.bin")));
  dir_.write("b.bin", simple_);
  expectRoom(load(outside(3, "b.bin")));
}

TEST_F(Clouds, cloudsOfTheMapThatThisOneWasMadeFromAreRead) {
  std::filesystem::create_directories(dir_.path("final_map_Images"));
  dir_.write("final_map_Images/lidar_1700000000.5.bin", test::gzipped(simple_));
  expectRoom(load(outside(3, "lidar_1700000000.5.bin")));
  EXPECT_NE(errorOf(outside(3, "lidar_1700000001.5.bin")).find("run_Images"), std::string::npos);
}

TEST_F(Clouds, filesOfKittiAndTextsAreRead) {
  std::string kitti, text;
  for (const auto& p : points_) {
    kitti += test::raw(p.x) + test::raw(p.y) + test::raw(p.z) + test::raw(0.5f);
    text += std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
  }
  writeBeside("a.bin", kitti);
  expectRoom(load(outside(1, "a.bin")));
  writeBeside("a.txt", text);
  expectRoom(load(outside(2, "a.txt")));
}

TEST_F(Clouds, missingFilesAreNamedInOneLine) {
  const std::string text = errorOf(outside(3, "lidar_17.bin"));
  EXPECT_NE(text.find("1 of its 1 point clouds"), std::string::npos) << text;
  EXPECT_NE(text.find("lidar_17.bin"), std::string::npos) << text;
  EXPECT_NE(text.find("run_Images"), std::string::npos) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST_F(Clouds, damagedFilesBesideTheMapAreRefused) {
  writeBeside("a.bin", simple_.substr(0, 500));
  EXPECT_NE(errorOf(outside(3, "a.bin")).find("a.bin"), std::string::npos);
  writeBeside("a.bin", test::streamed(test::smallGrid()));
  EXPECT_NE(errorOf(outside(3, "a.bin")).find("COccupancyGridMap2D"), std::string::npos);
}

TEST_F(Clouds, pointsOf3DRangeScansGiveTheRoom) {
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

TEST_F(Clouds, depthImagesGiveTheWallsThatTheyShow) {
  for (const bool isDepth : {true, false}) {
    SCOPED_TRACE(isDepth);
    const GreyMap map = load(oneObservation(test::streamed(wallSeen(isDepth))));
    const Grid grid = binarize(map, {});
    int walls = 0;
    for (int y = 0; y < grid.frame.height; ++y)
      for (int x = 0; x < grid.frame.width; ++x)
        if (grid.at({x, y}) == State::occupied) {
          EXPECT_NEAR(grid.frame.center({x, y}).x, 2, 0.08);
          ++walls;
        }
    EXPECT_GT(walls, 50) << "3.2 m of wall are in view";
    EXPECT_TRUE(grid.isFree({1, 0}));
  }
}

TEST_F(Clouds, of3DRangeScansTimeAndLabelAreKnown) {
  auto scan = wallSeen(true);
  for (const bool hasPoints : {false, true}) {
    scan.hasPoints3D = hasPoints;
    if (hasPoints) scan.resizePoints3DVectors(7);
    const auto info =
        loadRunInfo(dir_.write("run.simplemap", oneObservation(test::streamed(scan))));
    ASSERT_TRUE(info && info->start);
    EXPECT_NEAR(*info->start, 1.7e9, 1e-6);
    EXPECT_EQ(info->sensors.count("camera (CObservation3DRangeScan 10)"), 1u);
  }
}

TEST_F(Clouds, pointsOfVelodyneScansGiveTheRoom) {
  mrpt::obs::CObservationVelodyneScan scan;
  scan.sensorPose = sensor_;
  for (const auto& p : points_) {
    scan.point_cloud.x.push_back(p.x);
    scan.point_cloud.y.push_back(p.y);
    scan.point_cloud.z.push_back(p.z);
    scan.point_cloud.intensity.push_back(1);
  }
  expectRoom(load(oneObservation(test::streamed(scan))));
}

TEST_F(Clouds, packetsOfVelodyneScansArePlacedByMrpt) {
  mrpt::obs::CObservationVelodyneScan scan;
  scan.timestamp = mrpt::Clock::now();
  scan.calibration = mrpt::obs::VelodyneCalibration::LoadDefaultCalibration("VLP16");
  for (int packet = 0; packet < 75; ++packet) {
    mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket raw{};
    for (int block = 0; block < 12; ++block) {
      auto* bytes = reinterpret_cast<std::uint8_t*>(&raw.blocks[block]);
      const std::uint16_t azimuth = std::uint16_t((packet * 12 + block) * 40);
      bytes[0] = 0xff, bytes[1] = 0xee;
      std::memcpy(bytes + 2, &azimuth, 2);
      for (int k = 0; k < 32; ++k) {
        const std::uint16_t distance = 1500;  // 3 m in units of 2 mm
        std::memcpy(bytes + 4 + 3 * k, &distance, 2);
      }
    }
    scan.scan_packets.push_back(raw);
  }
  const Grid grid = binarize(load(oneObservation(test::streamed(scan))), {});
  int walls = 0;
  for (int y = 0; y < grid.frame.height; ++y)
    for (int x = 0; x < grid.frame.width; ++x)
      if (grid.at({x, y}) == State::occupied) {
        const double distance = norm(grid.frame.center({x, y}));
        EXPECT_GT(distance, 2.8);
        EXPECT_LT(distance, 3.1);
        ++walls;
      }
  EXPECT_GT(walls, 200) << "rings at 3 m and 1 to 15 degrees up or down";
}

/** A CObservationRotatingScan as MRPT 2.11 and later write it, or earlier. */
std::string rotatingScan(const CPose3D& sensor, std::uint16_t rows, std::uint16_t columns,
                         const std::string& matrices) {
  const std::string name = "mrpt::obs::CObservationRotatingScan";
  const std::string text = test::raw(std::uint32_t(1)) + "x";
  return std::string(1, char(0x80 | name.size())) + name + '\0' + test::raw<std::int64_t>(1) +
         text + test::raw(rows) + test::raw(columns) + test::raw(0.01) + test::raw(-M_PI) +
         test::raw(2 * M_PI) + test::raw(0.1) + text + test::raw(0.5) + test::raw(100.0) +
         test::streamed(sensor) + test::raw<std::int64_t>(1) + '\0' + matrices + "\x88";
}

TEST_F(Clouds, pointsInRowsAndColumnsGiveTheRoom) {
  // They are in the frame of the robot already, whatever the pose of the sensor.
  const test::Points points = test::roomPoints();
  const std::uint16_t columns = 100, rows = std::uint16_t(points.size() / columns);
  const std::string size = test::raw(columns) + test::raw(rows);
  std::string matrices = std::string(1, '\0') + size + std::string(2u * columns * rows, '\1') +
                         size + std::string(1u * columns * rows, '\1') +
                         test::raw<std::uint16_t>(1) + test::raw(std::uint32_t(1)) + "y" +
                         std::string(2u * columns * rows, '\1') + size;
  for (std::size_t i = 0; i < std::size_t(columns) * rows; ++i)
    matrices += test::raw(points[i].x) + test::raw(points[i].y) + test::raw(points[i].z);
  expectRoom(load(oneObservation(rotatingScan(sensor_, rows, columns, matrices))));
}

TEST_F(Clouds, scannersWithOneRingGiveTheirPlaneInBothLayouts) {
  constexpr std::uint16_t columns = 720;
  std::string ranges;
  for (int i = 0; i < columns; ++i) {
    const double angle = -M_PI + 2 * M_PI * i / columns;
    const double range = 2 / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
    ranges += test::raw(std::uint16_t(std::lround(range / 0.01)));
  }
  const std::string size = test::raw(columns) + test::raw<std::uint16_t>(1);
  const std::string earlier =
      size + ranges + size + std::string(columns, '\1') + std::string(2, '\0');
  for (const std::string& matrices :
       {earlier, std::string(1, '\0') + earlier + std::string(4, '\0')})
    expectRoom(load(oneObservation(rotatingScan(CPose3D(), 1, columns, matrices))));
}

TEST_F(Clouds, whatIsCutOffOrLiesIsRefused) {
  const std::string bytes = inside(simple_);
  for (std::size_t size = 1; size < bytes.size(); size += 1 + size / 8)
    EXPECT_NE(errorOf(bytes.substr(0, size)), "") << size;
  EXPECT_NE(errorOf(bytes.substr(0, bytes.size() - 1)), "");
  std::string lies = simple_;
  for (const std::uint32_t count :
       {0xffffffffu, 0x40000000u, std::uint32_t(points_.size() + 9000)}) {
    const std::size_t at = 2 + std::string("mrpt::maps::CSimplePointsMap").size();
    lies.replace(at, 4, test::raw(count));
    EXPECT_NE(errorOf(inside(lies)), "") << count;
  }
  EXPECT_NE(errorOf(inside(test::streamed(test::smallGrid()))).find("COccupancyGridMap2D"),
            std::string::npos);
}

TEST_F(Clouds, pointsThatAreNoPointsAreLeftOut) {
  test::Points points = points_;
  for (std::size_t i = 0; i < points.size(); i += 50) points[i].x = NAN;
  for (std::size_t i = 7; i < points.size(); i += 90) points[i].z = INFINITY;
  for (std::size_t i = 9; i < points.size(); i += 90) points[i].y = 1e30f;
  expectRoom(load(inside(pointsMapBytes("mrpt::maps::CSimplePointsMap", 10, points, ""))));
  EXPECT_NE(errorOf(inside(pointsMapBytes("mrpt::maps::CSimplePointsMap", 10,
                                          test::Points(5, {NAN, 0, 0}), ""))),
            "");
}

TEST_F(Clouds, emptyCloudsAreNoMap) {
  EXPECT_NE(errorOf(inside("\x87nullptr")).find("no point cloud"), std::string::npos);
  EXPECT_NE(errorOf(inside(pointsMapBytes("mrpt::maps::CSimplePointsMap", 10, {}, ""))), "");
}

TEST_F(Clouds, theSliceCanBeSetAndIsNoted) {
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

TEST_F(Clouds, scansGoBeforeCloudsUnlessASliceIsAskedFor) {
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

TEST_F(Clouds, keyframesOfCloudsAreTheirSlices) {
  const auto frames = loadKeyframes(dir_.write("run.simplemap", inside(simple_)), 30);
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
  int near = 0, all = 0;
  for (int y = 0; y < sliced.frame.height; ++y)
    for (int x = 0; x < sliced.frame.width; ++x) {
      if (sliced.at({x, y}) != State::occupied) continue;
      ++all;
      const Cell c = scans.frame.cellAt(sliced.frame.center({x, y}));
      bool isNear = false;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          isNear = isNear || scans.atOrUnknown({c.x + dx, c.y + dy}) == State::occupied;
      near += isNear;
    }
  EXPECT_GT(all, 5000);
  EXPECT_GT(near, 0.95 * all);
}

TEST(SlicedRun, namesTheFilesThatAreMissing) {
  const std::string file = test::sharedFile("mrpt_new/v1_external_cloud.simplemap");
  if (file.empty()) GTEST_SKIP() << "the run is not there";
  try {
    loadGrid(file, {});
    FAIL();
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find("lidar_0.bin"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace roomgraph
