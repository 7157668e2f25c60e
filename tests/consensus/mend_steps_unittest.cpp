#include "roomgraph/consensus/mend_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sample_drives.h"

namespace roomgraph {
namespace {

MendedSteps mended(const std::vector<Keyframe>& frames) {
  return mendSteps(localScans(test::runOf(frames).scans), test::posesOf(frames));
}

std::ptrdiff_t contradictions(const MendedSteps& steps) {
  return std::count(steps.evidence.begin(), steps.evidence.end(), StepEvidence::contradicts);
}

TEST(MendSteps, aSoundDriveIsLeftAsItIs) {
  const MendedSteps steps = mended(test::driveOnce());
  EXPECT_EQ(test::stepsApart(steps.poses, test::posesOf(test::driveOnce())), 0);
  EXPECT_EQ(contradictions(steps), 0);
  EXPECT_GT(std::count(steps.evidence.begin(), steps.evidence.end(), StepEvidence::agrees), 30);
}

TEST(MendSteps, aTearIsMendedFromTheScansOnBothSidesOfIt) {
  for (const double turn : {0.4, 2.2, M_PI, -1.3}) {
    const auto torn = test::broken(test::driveOnce(), 18, turn, {2, -1});
    const MendedSteps steps = mended(torn);
    EXPECT_LT(test::stepsApart(steps.poses, test::posesOf(test::driveOnce())), 0.15) << turn;
    EXPECT_EQ(steps.evidence[18], StepEvidence::contradicts) << turn;
    EXPECT_EQ(contradictions(steps), 1) << turn;
  }
}

TEST(MendSteps, aRobotThatNeverDrivesBackIsNotLaidBehindItself) {
  // Behind the tear it sees what it saw three steps before, as where a building repeats itself.
  const std::vector<Keyframe>& once = test::driveOnce();
  std::vector<Keyframe> frames(once.begin(), once.begin() + 10);
  frames.insert(frames.end(), once.begin() + 7, once.end());
  const MendedSteps steps = mended(test::broken(frames, 10, 0.8, {3, 0}));
  EXPECT_GT((steps.poses[9].inverse() * steps.poses[10]).x, -0.5);
}

TEST(MendSteps, twoTearsAreMendedEachByItself) {
  auto torn = test::broken(test::driveOnce(), 12, 0.8, {1, 1});
  torn = test::broken(torn, 30, -0.5, {0, 2});
  const MendedSteps steps = mended(torn);
  EXPECT_LT(test::stepsApart(steps.poses, test::posesOf(test::driveOnce())), 0.2);
  EXPECT_EQ(contradictions(steps), 2);
}

TEST(MendSteps, aScanThatLiesWrongOnItsOwnIsMendedByItself) {
  for (const double turn : {0.2, -0.25, 0.1, -0.12}) {
    std::vector<Keyframe> frames = test::driveOnce();
    frames[18].pose.phi += turn;
    const MendedSteps steps = mended(frames);
    EXPECT_LT(test::stepsApart(steps.poses, test::posesOf(test::driveOnce())), 0.15) << turn;
    EXPECT_EQ(steps.evidence[18], StepEvidence::contradicts) << turn;
    EXPECT_EQ(steps.evidence[19], StepEvidence::contradicts) << turn;
    EXPECT_EQ(contradictions(steps), 2) << turn;
  }
}

TEST(MendSteps, aTurnThatScansOnBothSidesTellAlikeIsMended) {
  for (const double turn : {0.2, 0.12, -0.12, -0.2}) {
    const MendedSteps steps = mended(test::broken(test::driveOnce(), 24, turn, {0.05, 0.05}));
    EXPECT_LT(test::stepsApart(steps.poses, test::posesOf(test::driveOnce())), 0.05) << turn;
    EXPECT_EQ(steps.evidence[24], StepEvidence::contradicts) << turn;
    EXPECT_EQ(contradictions(steps), 1) << turn;
  }
}

/** A drive round a ring corridor, 2 m wide, with niches in its outer wall that are so deep. */
std::vector<Keyframe> driveRoundARing(double radius, double niches, double step) {
  Grid grid;
  const double resolution = 0.05;
  const int side = int(2 * (radius + 3) / resolution);
  grid.frame = {side, side, resolution, {-side * resolution / 2, -side * resolution / 2}};
  grid.cells.resize(std::size_t(side) * std::size_t(side), State::occupied);
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    const Point at = grid.frame.center({int(i % std::size_t(side)), int(i / std::size_t(side))});
    const double niche = std::fmod(std::atan2(at.y, at.x) * radius + 100, 5.0) < 1 ? niches : 0;
    if (std::abs(norm(at) - radius) < 1 || (norm(at) > radius && norm(at) < radius + 1 + niche))
      grid.cells[i] = State::free;
  }
  std::vector<Transform2D> poses;
  for (double angle = 0; angle < 2 * M_PI; angle += step / radius)
    poses.push_back({radius * std::cos(angle), radius * std::sin(angle), angle + M_PI / 2});
  return test::drawnDrive(grid, poses);
}

TEST(MendSteps, scansThatSlideAlongABentCorridorTellNoTurn) {
  for (const double radius : {6.0, 10.0, 14.0})
    for (const double niches : {0.0, 0.4})
      for (const double step : {0.5, 0.8, 1.2})
        EXPECT_EQ(contradictions(mended(driveRoundARing(radius, niches, step))), 0)
            << radius << ' ' << niches << ' ' << step;
}

TEST(MendSteps, aScanThatFitsWhereTheRobotCannotHaveBeenIsNotMended) {
  // It has seen what it would have seen to the right of where it was drawn, or so far ahead that no
  // other step is as long.
  const auto contradictionsOf = [](Point moved) {
    std::vector<Keyframe> frames = test::driveOnce();
    for (Point& end : frames[18].ends) end = end + moved;
    return contradictions(mended(frames));
  };
  EXPECT_EQ(contradictionsOf({0.05, 0.6}), 2);
  EXPECT_EQ(contradictionsOf({-0.5, -0.6}), 0);
}

TEST(MendSteps, aSlipIsMendedForAllThatComesBehindIt) {
  const auto slipped = test::broken(test::driveOnce(), 18, 0.15, {0.4, 0.3});
  const MendedSteps steps = mended(slipped);
  EXPECT_LT(test::stepsApart(steps.poses, test::posesOf(test::driveOnce())), 0.15);
  EXPECT_EQ(contradictions(steps), 1);
}

/** What a scanner of 80 degrees that is turned by `bearing` sees, as if the robot were so. */
Keyframe lookingTo(Keyframe frame, double bearing) {
  std::vector<Point> ends;
  for (const Point end : frame.ends)
    if (std::abs(wrappedAngle(std::atan2(end.y, end.x) - bearing)) < 0.7)
      ends.push_back(turned(end, -bearing));
  frame.ends = ends;
  frame.pose.phi = wrappedAngle(frame.pose.phi + bearing);
  return frame;
}

TEST(MendSteps, whoTurnsToWhatHeHasNotSeenIsNotTorn) {
  std::vector<Keyframe> frames = test::driveOnce();
  for (std::size_t k = 0; k < frames.size(); ++k)
    frames[k] = lookingTo(frames[k], k < 3 || k >= 18 ? -1.5 : 1.5);
  EXPECT_EQ(contradictions(mended(frames)), 0);
}

/** What a robot sees of a bay without two walls alike, within a sector. */
Keyframe seenInBay(std::size_t k, const Transform2D& pose, double bearing, double half) {
  Keyframe frame;
  frame.number = k, frame.pose = pose;
  for (int i = -314; i < 314; ++i) {
    const double a = 0.01 * i, range = 4 + 1.2 * std::sin(3 * a + 1) + 0.8 * std::cos(5 * a);
    if (std::abs(wrappedAngle(a - bearing)) < half)
      frame.ends.push_back(frame.pose.inverse()({range * std::cos(a), range * std::sin(a)}));
  }
  return frame;
}

TEST(MendSteps, whatNoneOfTheLastScansHasSeenIsLookedForInThoseBefore) {
  constexpr std::size_t kBreak = 20;
  std::vector<Keyframe> frames;
  for (std::size_t k = 0; k < 26; ++k)  // it turns all the time
    frames.push_back(seenInBay(k, {0.1 * double(k) - 1, 0, wrappedAngle(0.9 * double(k))},
                               k < kBreak ? 0 : M_PI, k < 8 ? M_PI : 1.2));
  for (const double turn : {-1.2, 0.8, 1.2}) {
    const MendedSteps steps = mended(test::broken(frames, kBreak, turn, {}));
    EXPECT_EQ(steps.evidence[kBreak], StepEvidence::contradicts) << turn;
    EXPECT_LT(test::stepsApart(steps.poses, test::posesOf(frames)), 0.05) << turn;
  }
}

TEST(MendSteps, whoTurnsMayComeFromBehind) {
  const auto contradictionsWith = [](double turn) {
    std::vector<Keyframe> frames;
    for (std::size_t k = 0; k < 60; ++k)
      frames.push_back(
          seenInBay(k, {0.03 * double(k) - 1, 0, k / 10 % 2 == 0 ? 2.0 : 0.0}, 0, 1.2));
    frames.push_back(seenInBay(60, {0.25, 0, turn}, M_PI, 1.2));  // what it has not seen yet
    return contradictions(mended(frames));
  };
  EXPECT_EQ(contradictionsWith(2), 0);
  EXPECT_GT(contradictionsWith(0), 0) << "it never drives back";
}

TEST(MendSteps, aClockThatIsSetBackBeginsAnotherDrive) {
  const std::vector<Keyframe>& once = test::driveOnce();
  std::vector<Keyframe> frames(once.begin(), once.begin() + 8);
  frames.insert(frames.end(), once.end() - 8, once.end());
  for (std::size_t k = 0; k < frames.size(); ++k) frames[k].number = k, frames[k].time = double(k);
  EXPECT_GT(contradictions(mended(frames)), 0) << "nobody drives so fast";
  for (std::size_t k = 8; k < frames.size(); ++k) *frames[k].time -= 20;
  EXPECT_EQ(contradictions(mended(frames)), 0);
}

TEST(MendSteps, onlyStepsThatAreAskedForAreTold) {
  const auto torn = test::broken(test::driveOnce(), 18, 0.8, {2, -1});
  std::vector<bool> asked(torn.size());
  const auto told = [&] {
    return mendSteps(localScans(test::runOf(torn).scans), test::posesOf(torn), asked);
  };
  EXPECT_EQ(contradictions(told()), 0);
  asked[18] = true;
  EXPECT_EQ(contradictions(told()), 1);
}

TEST(MendSteps, theFrameChangesNothing) {
  const auto torn = test::broken(test::driveOnce(), 18, 0.4, {2, -1});
  const MendedSteps here = mended(torn), there = mended(test::moved(torn, {30, -8, 1.1}));
  EXPECT_EQ(here.evidence, there.evidence);
  EXPECT_LT(test::stepsApart(here.poses, there.poses), 0.05);
}

TEST(MendSteps, scansThatShowNothingTellNothing) {
  std::vector<Keyframe> blind = test::driveOnce();
  for (Keyframe& frame : blind) frame.ends.clear();
  const MendedSteps steps = mended(blind);
  EXPECT_EQ(std::count(steps.evidence.begin(), steps.evidence.end(), StepEvidence::none),
            std::ptrdiff_t(blind.size()));
  EXPECT_TRUE(mendSteps({}, {}).poses.empty());
}

}  // namespace
}  // namespace roomgraph
