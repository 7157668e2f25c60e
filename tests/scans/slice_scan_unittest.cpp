#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_cloud.h"
#include "roomgraph/scans/find_slice.h"

namespace roomgraph {
namespace {

using mrpt::poses::CPose3D;

/** A band that holds all heights. */
const Slice kAll{0, -50, 50, false};

PlacedScan sliced(const CloudPoints& points, const Slice& slice = kAll, const CPose3D& robot = {},
                  const CPose3D& sensor = {}) {
  return sliceScan(points, robot + sensor, robot.z(), slice);
}

/** The range in a direction [rad, map frame]; 0 where nothing was seen. */
double rangeAt(const PlacedScan& placed, double direction) {
  const auto& scan = placed.scan;
  const std::size_t beams = scan.ranges.size();
  const double turns = direction / (2 * M_PI) + 0.5;
  const std::size_t beam = std::size_t(std::lround((turns - std::floor(turns)) * double(beams)));
  return scan.isValid[beam % beams] ? double(scan.ranges[beam % beams]) : 0;
}

std::size_t seen(const PlacedScan& placed) {
  return std::size_t(std::count(placed.scan.isValid.begin(), placed.scan.isValid.end(), 1));
}

TEST(SliceScan, aPointIsSeenWhereItIs) {
  const PlacedScan placed = sliced({{3, 0, 0}, {0, 2, 0}, {-1, -1, 0}});
  EXPECT_NEAR(rangeAt(placed, 0), 3, 1e-5);
  EXPECT_NEAR(rangeAt(placed, M_PI / 2), 2, 1e-5);
  EXPECT_NEAR(rangeAt(placed, -3 * M_PI / 4), std::sqrt(2), 1e-5);
  EXPECT_EQ(seen(placed), 3u);
}

TEST(SliceScan, ofSeveralInOneDirectionTheNearestIs) {
  const PlacedScan placed = sliced({{5, 0, 0}, {2, 0, 0.3}, {9, 0, 1}});
  EXPECT_NEAR(rangeAt(placed, 0), 2, 1e-5);
  EXPECT_EQ(seen(placed), 1u);
}

TEST(SliceScan, whatIsOutsideOfTheBandIsNot) {
  const Slice band{-0.4, 0.6, 1.1, false};  // 0.2 to 0.7 m above the robot's zero
  EXPECT_EQ(seen(sliced({{3, 0, 0.1}, {0, 3, 0.8}}, band)), 0u);
  EXPECT_EQ(seen(sliced({{3, 0, 0.25}, {0, 3, 0.65}}, band)), 2u);
}

TEST(SliceScan, heightsCountFromTheRobotWhereverItStands) {
  const Slice band{-0.4, 0.6, 1.1, false};
  const CPose3D upstairs(7, -3, 12, 1.1, 0, 0);
  const PlacedScan placed = sliced({{3, 0, 0.5}, {0, 3, 2}}, band, upstairs);
  EXPECT_EQ(seen(placed), 1u);
  EXPECT_NEAR(rangeAt(placed, 1.1), 3, 1e-4) << "in the direction that it has in the map";
  EXPECT_NEAR(placed.from.x(), 7, 1e-9);
  EXPECT_NEAR(placed.from.yaw(), 0, 1e-9) << "the scan is level and not turned";
}

TEST(SliceScan, theScanIsSeenFromTheSensor) {
  const CPose3D sensor(1, 0, 0.5, 0, 0, 0);
  const test::Points points = test::seenFrom(sensor, {{4, 0, 0.5}});
  const PlacedScan placed = sliced(points, kAll, {}, sensor);
  EXPECT_NEAR(placed.from.x(), 1, 1e-9);
  EXPECT_NEAR(rangeAt(placed, 0), 3, 1e-5);
}

TEST(SliceScan, theRobotItselfIsNotSeen) {
  EXPECT_EQ(seen(sliced({{0.1, 0, 0}, {0, -0.15f, 0.2f}})), 0u);
}

/** Points of a wall at x = 3, so many degrees apart. */
test::Points wallOf(double degrees) {
  test::Points points;
  for (double at = -20; at <= 20; at += degrees)
    points.push_back({3, float(3 * std::tan(at * M_PI / 180)), 0});
  return points;
}

TEST(SliceScan, pointsOfOneSurfaceAreJoined) {
  const PlacedScan placed = sliced(wallOf(0.5));
  EXPECT_GT(seen(placed), 390u) << "each of the 400 directions";
  for (double at = -19.9; at < 19.9; at += 0.37)
    EXPECT_NEAR(rangeAt(placed, at * M_PI / 180), 3 / std::cos(at * M_PI / 180), 0.01) << at;
}

TEST(SliceScan, pointsFarApartAreNotJoined) {
  EXPECT_EQ(seen(sliced(wallOf(4))), 11u);
  const PlacedScan step = sliced({{3, 0, 0}, {6, 0.05f, 0}});
  EXPECT_EQ(seen(step), 2u) << "one stands behind the other";
}

TEST(SliceScan, theIdentityIsThatOfThePoints) {
  const test::Points points = test::roomPoints();
  test::Points other = points;
  other.back().z += 0.001f;
  const std::uint64_t id = sliced(points).id;
  EXPECT_EQ(sliced(points, {}, CPose3D(5, 5, 0, 1, 0, 0)).id, id)
      << "wherever the robot was, and whatever was cut out";
  EXPECT_NE(sliced(other).id, id);
}

TEST(RangesId, isOfTheValidRangesAlone) {
  RangeScan scan;
  scan.ranges = {1, 2, 3, 4};
  scan.isValid = {1, 1, 0, 1};
  RangeScan other = scan, fewer = scan;
  other.ranges[2] = 99;
  EXPECT_EQ(rangesId(other), rangesId(scan)) << "what is not valid says nothing";
  fewer.isValid[1] = 0;
  EXPECT_NE(rangesId(fewer), rangesId(scan));
  other.ranges[3] = 4.5;
  EXPECT_NE(rangesId(other), rangesId(scan));
}

TEST(SliceScan, anEmptyCloudSeesNothing) { EXPECT_EQ(seen(sliced({})), 0u); }

}  // namespace
}  // namespace roomgraph
