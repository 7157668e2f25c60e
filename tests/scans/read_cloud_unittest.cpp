#include <gtest/gtest.h>

#include <cmath>

#include "clouds.h"
#include "point_maps.h"

namespace roomgraph {
namespace {

using mrpt::poses::CPose3D;
using test::oneObservation;
using test::pointsMapBytes;

class ReadCloud : public test::Clouds {};

TEST_F(ReadCloud, everyClassOfPointsGivesTheRoom) {
  const std::vector<mrpt::maps::CPointsMap::Ptr> maps = test::pointMaps();
  ASSERT_GT(maps.size(), 1u);
  for (const mrpt::maps::CPointsMap::Ptr& map : maps) {
    map->resize(points_.size());  // insertPoint() gives no weights and colours since MRPT 2.15
    for (std::size_t i = 0; i < points_.size(); ++i)
      map->setPoint(i, points_[i].x, points_[i].y, points_[i].z);
    SCOPED_TRACE(map->GetRuntimeClass()->className);
    expectRoom(load(inside(test::streamed(*map))));
  }
}

TEST_F(ReadCloud, classesThatThisMrptDoesNotHaveGiveTheRoom) {
  // What is behind the points is not looked at.
  const std::string intensities(points_.size() * 4, '\x3f');
  expectRoom(load(inside(pointsMapBytes("mrpt::maps::CPointsMapXYZIRT", 0, points_, intensities))));
  for (const int version : {3, 4})
    expectRoom(load(inside(pointsMapBytes("mrpt::maps::CGenericPointsMap", version, points_,
                                          test::raw<std::uint32_t>(1) + intensities))));
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

TEST_F(ReadCloud, pointsInRowsAndColumnsGiveTheRoom) {
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

TEST_F(ReadCloud, scannersWithOneRingGiveTheirPlaneInBothLayouts) {
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

TEST_F(ReadCloud, whatIsCutOffOrLiesIsRefused) {
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

TEST_F(ReadCloud, pointsThatAreNoPointsAreLeftOut) {
  test::Points points = points_;
  for (std::size_t i = 0; i < points.size(); i += 50) points[i].x = NAN;
  for (std::size_t i = 7; i < points.size(); i += 90) points[i].z = INFINITY;
  for (std::size_t i = 9; i < points.size(); i += 90) points[i].y = 1e30f;
  expectRoom(load(inside(pointsMapBytes("mrpt::maps::CSimplePointsMap", 10, points, ""))));
  EXPECT_NE(errorOf(inside(pointsMapBytes("mrpt::maps::CSimplePointsMap", 10,
                                          test::Points(5, {NAN, 0, 0}), ""))),
            "");
}

TEST_F(ReadCloud, emptyCloudsAreNoMap) {
  EXPECT_NE(errorOf(inside("\x87nullptr")).find("no point cloud"), std::string::npos);
  EXPECT_NE(errorOf(inside(pointsMapBytes("mrpt::maps::CSimplePointsMap", 10, {}, ""))), "");
}

}  // namespace
}  // namespace roomgraph
