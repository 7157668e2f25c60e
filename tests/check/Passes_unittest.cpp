#include "Passes.h"

#include <gtest/gtest.h>

#include "sample_drives.h"

namespace roomgraph {
namespace {

TEST(Passes, cutTheWholeRunIntoStretchesThatHaveDrawnAMap) {
  const auto frames = test::driveForthAndBack();
  const auto scans = localScans(test::runOf(frames).scans);
  const auto poses = test::posesOf(frames);
  const Passes passes(scans, poses);
  std::size_t next = 0;
  for (const Pass& pass : passes.all()) {
    EXPECT_EQ(pass.first, next);
    EXPECT_GT(pass.end, pass.first);
    EXPECT_FALSE(pass.map.walls.empty());
    next = pass.end;
  }
  EXPECT_EQ(next, frames.size());
}

TEST(Passes, aScanIsHeldAgainstThoseOfAnotherTimeNearBy) {
  const auto frames = test::driveForthAndBack();
  const auto scans = localScans(test::runOf(frames).scans);
  const auto poses = test::posesOf(frames);
  const Passes passes(scans, poses);
  EXPECT_FALSE(passes.besideScan(0).empty()) << "the robot has come back to where it began";
  for (std::size_t k = 0; k < frames.size(); ++k)
    for (const std::size_t beside : passes.besideScan(k)) {
      const Pass& pass = passes.all()[beside];
      const bool isAhead = k < pass.first;
      EXPECT_GT(isAhead ? passes.pathBetween(k, pass.first) : passes.pathBetween(pass.end - 1, k),
                kWayRound);
    }
}

TEST(Passes, whatLiesFartherInPathMayBeFartherOff) {
  const auto frames = test::driveForthAndBack();
  const auto scans = localScans(test::runOf(frames).scans);
  const auto poses = test::posesOf(frames);
  const Passes passes(scans, poses);
  const PoseTolerance near = passes.windowOf(0, passes.all()[1]);
  const PoseTolerance far = passes.windowOf(0, passes.all().back());
  EXPECT_LT(near.place, far.place);
  EXPECT_LT(near.turn, far.turn);
}

TEST(Passes, ofNoScansThereAreNone) { EXPECT_TRUE(Passes({}, {}).all().empty()); }

}  // namespace
}  // namespace roomgraph
