#include <gtest/gtest.h>

#include "roomgraph/check/check_run.h"
#include "roomgraph/repair/repair_runs.h"
#include "roomgraph/repair/sound_frame.h"
#include "sample_drives.h"

namespace roomgraph {
namespace {

RepairedRun repaired(const std::vector<Keyframe>& frames) {
  const Run run = test::runOf(frames);
  return repairAlone(run, checkRun(run));
}

double movedMost(const std::vector<Transform2D>& poses, const std::vector<Keyframe>& frames) {
  double most = 0;
  for (std::size_t k = 0; k < poses.size(); ++k)
    most = std::max(most, poseDistance(poses[k], frames[k].pose));
  return most;
}

TEST(RepairAlone, aTornRunIsPutTogetherAndItsLargerPartStays) {
  const std::vector<Keyframe> sound = test::driveForthAndBack();
  for (const std::size_t at : {std::size_t(20), sound.size() - 20}) {
    const auto torn = test::broken(sound, at, 0.7, {1, -2});
    const RepairedRun run = repaired(torn);
    EXPECT_EQ(run.state, RepairState::mended) << run.reason;
    EXPECT_LT(test::stepsApart(run.poses, test::posesOf(sound)), 0.2);
    const std::size_t stays = at < sound.size() / 2 ? sound.size() - 1 : 0;
    EXPECT_LT(poseDistance(run.poses[stays], torn[stays].pose), 0.2);
    EXPECT_GT(run.movedMost, 1);
  }
}

TEST(RepairAlone, aShortEndThatBreaksIsMendedThoughItsErrorMayBeZero) {
  const std::vector<Keyframe> sound = test::driveForthAndBack();
  const auto torn = test::broken(sound, sound.size() - 3, 0.3, {0.4, 0.3});
  const RepairedRun run = repaired(torn);
  EXPECT_EQ(run.state, RepairState::mended) << run.reason;
  EXPECT_LT(test::stepsApart(run.poses, test::posesOf(sound)), 0.2);
}

TEST(RepairAlone, whatAgreesWithItselfStaysAsItWas) {
  const RepairedRun run = repaired(test::driveForthAndBack());
  EXPECT_EQ(run.state, RepairState::kept);
  EXPECT_EQ(movedMost(run.poses, test::driveForthAndBack()), 0);
}

TEST(RepairAlone, aTearThatNothingSeenTwiceBearsOutStaysAsItWas) {
  const auto torn = test::broken(test::driveOnce(), 18, 2.2, {2, -1});
  const RepairedRun run = repaired(torn);
  EXPECT_EQ(run.state, RepairState::kept) << run.reason;
  EXPECT_EQ(movedMost(run.poses, torn), 0);
  ASSERT_EQ(run.unseen.size(), 1u);
  EXPECT_EQ(run.unseen[0].to, torn.back().number);
}

}  // namespace
}  // namespace roomgraph
