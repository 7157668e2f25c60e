#include "roomgraph/check/check_run.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sample_drives.h"

namespace roomgraph {
namespace {

RunCheck checked(const std::vector<Keyframe>& frames) { return checkRun(test::runOf(frames)); }

TEST(CheckRun, aSoundRunAgreesWithItselfAndHasNoBreak) {
  const RunCheck check = checked(test::driveForthAndBack());
  ASSERT_TRUE(check.selfError);
  EXPECT_LT(*check.selfError, 0.03);
  EXPECT_TRUE(check.breaks.empty());
  EXPECT_GT(check.seenTwice, 0.5);
  EXPECT_NE(check.sentence.find("agrees with itself"), std::string::npos);
}

TEST(CheckRun, aTornRunIsToldBeforeItsFirstKeyFrameBehindTheTear) {
  for (const double turn : {0.3, 1.6, -2.8}) {
    const RunCheck check = checked(test::broken(test::driveForthAndBack(), 50, turn, {1, 2}));
    ASSERT_EQ(check.breaks.size(), 1u) << turn;
    EXPECT_EQ(check.breaks.front().keyFrame, 50u);
    EXPECT_NEAR(wrappedAngle(check.breaks.front().rotation - turn), 0, 0.05);
    ASSERT_TRUE(check.selfError);
    EXPECT_LE(check.low, *check.selfError);
    EXPECT_GE(check.high, *check.selfError);
    EXPECT_TRUE(check.isConfirmed);
  }
}

TEST(CheckRun, whereScansComeAStepLateTheClockIsToBlame) {
  std::vector<Transform2D> poses = test::posesOf(test::driveForthAndBack());
  for (std::size_t k = 0; k < poses.size(); ++k) poses[k].phi += k % 4 < 2 ? 0.35 : -0.35;
  const auto checkedAs = [&](std::size_t late) {
    std::vector<Keyframe> frames = test::drawnDrive(test::drawnBuilding(4, {}), poses);
    for (std::size_t k = frames.size(); k-- > late;) frames[k].ends = frames[k - late].ends;
    return checked(frames);
  };
  const RunCheck late = checkedAs(1);
  EXPECT_FALSE(late.selfError);
  EXPECT_NE(late.sentence.find("clock"), std::string::npos) << late.sentence;
  EXPECT_EQ(checkedAs(0).sentence.find("clock"), std::string::npos);
}

TEST(CheckRun, aRunThatBendsLittleByLittleHasNoBreak) {
  const std::vector<Keyframe> sound = test::driveForthAndBack();
  for (const double turn : {0.006, -0.006}) {  // of each step, as of a gyro
    std::vector<Keyframe> bent = sound;
    for (std::size_t k = 1; k < bent.size(); ++k)
      bent[k].pose =
          bent[k - 1].pose * sound[k - 1].pose.inverse() * sound[k].pose * Transform2D{0, 0, turn};
    const RunCheck check = checked(bent);
    EXPECT_TRUE(check.breaks.empty()) << turn;
    ASSERT_TRUE(check.selfError) << turn;
    EXPECT_GT(*check.selfError, 0.5);
    EXPECT_NE(check.sentence.find("contradicts itself by"), std::string::npos);
  }
}

TEST(CheckRun, ofWhatWasDrivenOnceNothingIsTold) {
  const auto& once = test::driveOnce();
  const RunCheck check = checked({once.begin(), once.begin() + 20});
  EXPECT_FALSE(check.selfError);
  EXPECT_TRUE(check.breaks.empty());
  EXPECT_EQ(check.seenTwice, 0);
  EXPECT_EQ(check.sentence.rfind("cannot tell", 0), 0u);
}

TEST(CheckRun, aTearOfWhatWasDrivenOnceIsToldAndNotConfirmed) {
  const RunCheck check = checked(test::broken(test::driveOnce(), 18, 2.2, {2, -1}));
  EXPECT_EQ(check.breaks.size(), 1u);
  EXPECT_FALSE(check.isConfirmed);
}

TEST(CheckRun, ofAScanThatFitsNowhereABreakIsToldWithoutASize) {
  // It sees something everywhere where free space was seen before.
  test::RandomNumbers random(3);
  std::vector<Keyframe> frames = test::driveOnce();
  for (std::size_t k = 18; k < frames.size(); ++k)
    for (Point& end : frames[k].ends) end = random.between(0.2, 0.6) * end;
  const RunCheck check = checked(frames);
  ASSERT_FALSE(check.breaks.empty());
  EXPECT_FALSE(check.isConfirmed);
  EXPECT_TRUE(std::any_of(check.breaks.begin(), check.breaks.end(), [](const MapBreak& tear) {
    return !tear.torn && *tear.keyFrame >= 17 && *tear.keyFrame <= 20;
  }));
  EXPECT_FALSE(check.selfError);
  EXPECT_NE(check.sentence.find("cannot tell: the run breaks before key"), std::string::npos);
}

TEST(CheckRun, aRobotThatStandsStillTellsNothing) {
  const std::vector<Keyframe> still(30, test::driveOnce().front());
  const RunCheck check = checked(still);
  EXPECT_FALSE(check.selfError);
  EXPECT_TRUE(check.breaks.empty());
}

TEST(CheckRun, ofAGridOnlyWhatItsWallsShowIsTold) {
  roomgraph::Run grid;
  grid.map.wallDoubling = 0.12, grid.map.axisDeviation = M_PI / 90;
  const RunCheck check = checkRun(grid);
  EXPECT_FALSE(check.selfError);
  EXPECT_EQ(check.sentence.rfind("cannot tell", 0), 0u);
  EXPECT_NE(check.sentence.find("12 % of its walls stand in front of another"), std::string::npos);
  EXPECT_NE(check.sentence.find("by 2.0 degrees or more"), std::string::npos);
  EXPECT_EQ(check.evidence.size(), 3u);
  EXPECT_TRUE(check.breaks.empty() && check.doubled.empty());
}

TEST(CheckRun, aRunWithoutScansTellsNothing) {
  const RunCheck check = checkRun({});
  EXPECT_FALSE(check.selfError);
  EXPECT_EQ(check.sentence, "cannot tell: it has no scans");
}

}  // namespace
}  // namespace roomgraph
