#include "roomgraph/repair/repair_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "repaired_site.h"
#include "roomgraph/repair/sound_frame.h"

namespace roomgraph {
namespace {

/** How far poses are from the true ones after the best turn and shift, at the worst [m]. */
double misplaced(const std::vector<Transform2D>& poses) {
  std::vector<Transform2D> truth;
  for (const Keyframe& frame : test::drive(0)) truth.push_back(frame.pose);
  const Transform2D frame = soundFrame(poses, truth);
  double most = 0;
  for (std::size_t k = 0; k < poses.size(); ++k)
    most = std::max(most, poseDistance(poses[k], frame * truth[k]));
  return most;
}

TEST(RepairRuns, aTornRunIsPutTogetherWhereItsLargerPartWas) {
  const test::SolvedDrives& torn = test::tornAmongSound();
  const std::vector<RepairedRun> repaired = repairRuns(torn.solved, torn.real);
  ASSERT_EQ(repaired.size(), 3u);
  EXPECT_EQ(repaired[1].run, 1u);
  EXPECT_EQ(repaired[1].state, RepairState::mended) << repaired[1].reason;
  EXPECT_LT(misplaced(repaired[1].poses), 0.15);
  EXPECT_GT(repaired[1].movedMost, 1);
  const std::size_t scans = torn.runs[1].scans.size();
  const std::size_t sound = scans - 20 > 20 ? scans - 1 : 0;
  EXPECT_LT(poseDistance(repaired[1].poses[sound], torn.runs[1].scans[sound].pose), 0.1);
  EXPECT_TRUE(repaired[1].unseen.empty());
}

TEST(RepairRuns, aShortEndThatIsTornFarIsMended) {
  const std::vector<Keyframe> whole = test::drive(2);
  for (const double turn : {0.7, 1.6}) {
    const test::SolvedDrives torn({test::drifting(test::drive(1), 0.0003),
                                   test::broken(whole, whole.size() - 4, turn, {0.4, 0.2}),
                                   test::drifting(test::drive(3), -0.0003),
                                   test::drifting(test::drive(4), 0.0002)});
    const RepairedRun repaired = repairRuns(torn.solved, torn.real)[1];
    EXPECT_EQ(repaired.state, RepairState::mended) << repaired.reason;
    EXPECT_LT(misplaced(repaired.poses), 0.15) << turn;
  }
}

TEST(RepairRuns, mendedPosesAreSureAndOthersStayAsTheyAre) {
  const test::SolvedDrives& torn = test::tornAmongSound();
  const std::vector<RepairedRun> repaired = repairRuns(torn.solved, torn.real);
  EXPECT_TRUE(repaired[0].covariances.empty());
  ASSERT_EQ(repaired[1].covariances.size(), repaired[1].poses.size());
  for (const PlanarCovariance& sure : repaired[1].covariances) {
    EXPECT_GT(sure.xx, 0);
    EXPECT_LT(std::sqrt(sure.xx + sure.yy), 0.3);
    EXPECT_LT(std::sqrt(sure.pp), 0.05);
  }
}

TEST(RepairRuns, aRunWhoseErrorMayBeNoneStaysAsItWas) {
  const test::SolvedDrives& torn = test::tornAmongSound();
  const RepairedRun sound = repairRuns(torn.solved, torn.real)[0];
  EXPECT_EQ(sound.state, RepairState::kept) << sound.reason;
  for (std::size_t k = 0; k < sound.poses.size(); ++k)
    EXPECT_EQ(sound.poses[k].shift(), torn.runs[0].scans[k].pose.shift());
}

TEST(RepairRuns, aRunThatFitsInTwoWaysStaysAsItWas) {
  const test::SolvedDrives& torn = test::tornAmongSound();
  SolvedSite unsure = torn.solved;
  MapError& error = unsure.consensus.errors[unsure.consensus.graphRuns[1]];
  EXPECT_FALSE(fitsInTwoWays(error));
  error.low = 0.05 * error.error;  // as of another solution that is as good
  const RepairedRun kept = repairRuns(unsure, torn.real)[1];
  EXPECT_EQ(kept.state, RepairState::kept);
  EXPECT_NE(kept.reason.find("in two ways"), std::string::npos) << kept.reason;
  error.error = 0.3, error.low = 0.02;  // slight errors have wide intervals
  EXPECT_FALSE(fitsInTwoWays(error));
}

TEST(RepairRuns, aRunThatAloneHasSeenAWingIsTrustedWhereThatCannotBeFarOff) {
  MapError error;
  error.seen = 0.3, error.high = 0.3;
  EXPECT_TRUE(isTrusted(error));
  error.high = 0.5;
  EXPECT_FALSE(isTrusted(error));
  error.seen = 0.6;
  EXPECT_TRUE(isTrusted(error));
  EXPECT_FALSE(isTrusted(MapError())) << "nothing is known of what nobody else has seen";
}

TEST(RepairRuns, aRunThatWouldFitNoBetterStaysAsItWas) {
  const test::SolvedDrives site({test::drifting(test::drive(1), 0.01), test::drive(2)}, 1);
  RealPoses wrong = site.real;
  for (std::size_t k = 0; k < wrong[0].size(); ++k)
    wrong[0][k] = wrong[0][k] * (k % 2 ? Transform2D{1, 1, 0.5} : Transform2D{-1, -1, -0.5});
  const RepairedRun kept = repairRuns(site.solved, wrong)[0];
  EXPECT_EQ(kept.state, RepairState::kept) << kept.reason;
  for (std::size_t k = 0; k < kept.poses.size(); ++k)
    EXPECT_EQ(kept.poses[k].shift(), site.runs[0].scans[k].pose.shift());
}

TEST(RepairRuns, whatIsLeftIsAboutTheErrorOfAMendedRun) {
  const test::SolvedDrives& torn = test::tornAmongSound();
  const std::vector<RepairedRun> repaired = repairRuns(torn.solved, torn.real);
  EXPECT_FALSE(repaired[0].left);
  ASSERT_TRUE(repaired[1].left);
  EXPECT_LT(*repaired[1].left, misplaced(repaired[1].poses) + 0.05);
  RealPoses off = torn.real;
  for (std::size_t k = 0; k < off[1].size(); ++k)
    off[1][k] = off[1][k] * (k % 2 ? Transform2D{0.15, 0, 0} : Transform2D{-0.15, 0, 0});
  const RepairedRun moved = repairRuns(torn.solved, off)[1];
  ASSERT_TRUE(moved.left) << moved.reason;
  EXPECT_NEAR(*moved.left, 0.15, 0.05);
}

/** Each of these poses off on its own, by so many metres. */
std::vector<Transform2D> shaken(std::vector<Transform2D> poses, double by) {
  for (std::size_t k = 0; k < poses.size(); ++k)
    poses[k] = poses[k] * Transform2D{k % 2 ? by : -by, k % 3 ? by : -by, 0};
  return poses;
}

TEST(RepairRuns, keyFramesThatStayOffEachOnItsOwnAreNotMended) {
  std::vector<Keyframe> drive = test::drive(1);
  for (std::size_t k = 0; k < drive.size(); ++k)
    drive[k].pose = drive[k].pose * Transform2D{k % 2 ? 0.1 : -0.1, k % 3 ? 0.1 : -0.1, 0};
  const test::SolvedDrives site({drive, test::drive(2), test::drive(3)});
  std::vector<Transform2D> truth;
  for (const Keyframe& frame : test::drive(1)) truth.push_back(frame.pose);
  const Transform2D frame = soundFrame(site.real[0], truth);
  RealPoses real = site.real;
  for (Transform2D& pose : truth) pose = frame * pose;
  real[0] = shaken(truth, 0.09);
  EXPECT_EQ(repairRuns(site.solved, real)[0].state, RepairState::kept);
  real[0] = shaken(truth, 0.03);
  const RepairedRun mended = repairRuns(site.solved, real)[0];
  EXPECT_EQ(mended.state, RepairState::mended) << mended.reason;
}

TEST(RepairRuns, aReferenceStaysAndTheOthersFollow) {
  const test::SolvedDrives site({test::drifting(test::drive(1), 0.01), test::drive(2)}, 1);
  const std::vector<RepairedRun> repaired = repairRuns(site.solved, site.real);
  ASSERT_EQ(repaired.size(), 2u);
  EXPECT_EQ(repaired[1].state, RepairState::reference);
  EXPECT_EQ(repaired[0].state, RepairState::mended) << repaired[0].reason;
  std::vector<Transform2D> before;
  for (const ScanWalls& scan : site.runs[0].scans) before.push_back(scan.pose);
  EXPECT_LT(misplaced(repaired[0].poses), 0.25 * misplaced(before));
}

}  // namespace
}  // namespace roomgraph
