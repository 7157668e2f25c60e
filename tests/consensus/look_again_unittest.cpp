#include "look_again.h"

#include <gtest/gtest.h>

#include "drive_in_building.h"

namespace roomgraph {
namespace {

using Track = std::vector<std::optional<Transform2D>>;

/** Found where it was drawn, up to a scan. */
Track foundUpTo(std::size_t scan, std::size_t scans) {
  Track track(scans);
  for (std::size_t k = 0; k < scan; ++k) track[k] = Transform2D{};
  return track;
}

TEST(LookAgain, aRobotThatWasCarriedIsFoundInAllOfTheMap) {
  const auto& drive = test::driveInBuilding();
  const Transform2D back = drive.frames[20].pose;
  const auto carried = test::broken(drive.frames, 20, 2.2, {13, -9});
  const auto scans = scanWalls(carried);
  const auto poses = lookAgain(scans, foundUpTo(20, scans.size()), drive.map);
  ASSERT_FALSE(poses.empty());
  EXPECT_LE(poses.size(), 4u);
  EXPECT_LT(distance(poses[0](carried[20].pose.shift()), back.shift()), 0.3);
  EXPECT_LT(distance(poses[0](carried[30].pose.shift()), drive.frames[30].pose.shift()), 0.3);
}

TEST(LookAgain, whatGoesOnSmoothlyLiesWhereNobodyHasBeen) {
  const auto& drive = test::driveInBuilding();
  const auto scans = scanWalls(drive.frames);
  EXPECT_TRUE(lookAgain(scans, foundUpTo(20, scans.size()), drive.map).empty());
}

TEST(LookAgain, whereAllWasFoundOrAFewScansAreLostThereIsNothingToLookFor) {
  const auto& drive = test::driveInBuilding();
  const auto scans = scanWalls(test::broken(drive.frames, 20, 2.2, {13, -9}));
  Track track = foundUpTo(scans.size(), scans.size());
  EXPECT_TRUE(lookAgain(scans, track, drive.map).empty());
  for (std::size_t k = 20; k < 25; ++k) track[k].reset();
  EXPECT_TRUE(lookAgain(scans, track, drive.map).empty());
  EXPECT_TRUE(lookAgain({}, {}, drive.map).empty());
}

}  // namespace
}  // namespace roomgraph
