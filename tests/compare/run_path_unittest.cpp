#include "run_path.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

Run drive() {
  Run run;
  for (int k = 0; k < 3; ++k) {
    run.scans.emplace_back();
    run.scans.back().keyFrame = std::size_t(2 * k);
    run.scans.back().pose = {double(k), 2, 0.1};
    if (k > 0) run.scans.back().time = 1e9 + k;
  }
  return run;
}

TEST(RunPath, isThatOfTheRunInTheFrameOfTheSite) {
  const roomgraph::Run run = drive();
  MapError error;
  error.errors = {0.1, 0.2, 0.3};
  const Transform2D pose{10, -5, M_PI / 2};
  const std::vector<PathPose> path = runPath(run, pose, error);
  ASSERT_EQ(path.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(path[k].keyFrame, 2 * k) << "its number in the file, not among the scans";
    EXPECT_NEAR(path[k].pose.x, 8, 1e-12);
    EXPECT_NEAR(path[k].pose.y, -5 + double(k), 1e-12);
    EXPECT_NEAR(path[k].pose.phi, M_PI / 2 + 0.1, 1e-12);
    EXPECT_EQ(path[k].error, error.errors[k]);
    EXPECT_EQ(path[k].time, run.scans[k].time);
  }
}

TEST(RunPath, aCopyWithoutScansTellsNoErrors) {
  MapError ofPatches;
  ofPatches.errors = {0.1, 0.2};
  for (const PathPose& at : runPath(drive(), {}, ofPatches)) EXPECT_FALSE(at.error);
}

TEST(RunPath, whatNobodyBearsOutHasNoError) {
  MapError error;
  error.errors = {0.1, 0.2, 0.3}, error.isConfirmed = {true, false, true};
  const std::vector<PathPose> path = runPath(drive(), {}, error);
  EXPECT_EQ(path[0].error, 0.1);
  EXPECT_FALSE(path[1].error);
  EXPECT_EQ(path[2].error, 0.3);
}

TEST(RunPath, aRunWithoutScansHasNone) { EXPECT_TRUE(runPath({}, {}, {}).empty()); }

}  // namespace
}  // namespace roomgraph
