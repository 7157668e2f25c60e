#include "roomgraph/archive/watch_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace roomgraph {
namespace {

const WatchOptions kOptions;

/** The map errors of a robot: those of `truth` by night, off by a share as estimates are, and one
 *  night in thirty altogether bad. */
class Nights {
 public:
  Nights(unsigned seed, std::function<double(int)> truth)
      : random_(seed), truth_(std::move(truth)) {}

  void add() {
    const int night = int(samples.size());
    const double off = std::exp(0.3 * std::normal_distribution<>()(random_));
    const bool isBad = random_() % 30 == 0;
    samples.push_back({double(night), truth_(night) * off * (isBad ? 6 : 1)});
  }

  Samples samples;

 private:
  std::mt19937 random_;
  std::function<double(int)> truth_;
};

Samples everyNight(int count, double error) {
  Samples samples;
  for (int night = 0; night < count; ++night) samples.push_back({double(night), error});
  return samples;
}

TEST(WatchErrors, twoBadNightsInFiveAreNoAlarm) {
  Samples errors = everyNight(20, 0.1);
  errors[16].value = errors[19].value = 3;
  EXPECT_FALSE(watchErrors(errors, kOptions).isAlarm());
}

TEST(WatchErrors, threeBadNightsInFiveAreAboveTheLimit) {
  Samples errors = everyNight(20, 0.1);
  errors[16].value = errors[18].value = errors[19].value = 3;
  EXPECT_TRUE(watchErrors(errors, kOptions).isOverLimit);
}

TEST(WatchErrors, aSlowDeclineBelowTheLimitIsToldWithItsEnd) {
  Samples errors;
  for (int night = 0; night < 30; ++night) errors.push_back({double(night), 0.1 + 0.004 * night});
  const ErrorWatch watch = watchErrors(errors, kOptions);
  EXPECT_TRUE(watch.isDeclining);
  EXPECT_FALSE(watch.isOverLimit);
  ASSERT_TRUE(watch.slope);
  EXPECT_NEAR(watch.slope->perDay, 0.004, 1e-9);
  ASSERT_TRUE(watch.daysToLimit);
  EXPECT_NEAR(*watch.daysToLimit, (0.3 - 0.216) / 0.004, 1e-6);
}

TEST(WatchErrors, aStepIsToldWithItsNightUntilItIsMended) {
  Samples errors = everyNight(40, 0.1);
  for (std::size_t night = 25; night < 40; ++night) errors[night].value = 0.2;
  ErrorWatch watch = watchErrors(errors, kOptions);
  EXPECT_TRUE(watch.isChanged);
  ASSERT_TRUE(watch.change);
  EXPECT_EQ(watch.change->first, 25U);
  for (int night = 40; night < 45; ++night) errors.push_back({double(night), 0.1});
  watch = watchErrors(errors, kOptions);
  EXPECT_FALSE(watch.isChanged);
}

TEST(WatchErrors, theNightOfAChangeIsOneOfAllNights) {
  Samples errors = everyNight(200, 0.1);
  for (std::size_t night = 170; night < 200; ++night) errors[night].value = 0.2;
  const ErrorWatch watch = watchErrors(errors, kOptions);
  ASSERT_TRUE(watch.change);
  EXPECT_EQ(watch.change->first, 170U);
}

TEST(WatchErrors, whatIsTooSmallToMatterIsNoDecline) {
  Samples errors;
  for (int night = 0; night < 30; ++night) errors.push_back({double(night), 0.05 + 0.0005 * night});
  EXPECT_FALSE(watchErrors(errors, kOptions).isAlarm());
}

TEST(WatchErrors, fewNightsSayNothing) {
  EXPECT_FALSE(watchErrors({}, kOptions).isAlarm());
  EXPECT_FALSE(watchErrors(everyNight(4, 2), kOptions).isAlarm());
}

TEST(WatchErrors, aSoundRobotGivesAtMostOneAlarmAYear) {
  for (const double error : {0.05, 0.1, 0.15}) {
    int alarms = 0;
    const int robots = 40;
    for (unsigned seed = 0; seed < robots; ++seed) {
      Nights nights(seed, [&](int) { return error; });
      bool wasAlarm = false;
      for (int night = 0; night < 365; ++night) {
        nights.add();
        const bool isAlarm = watchErrors(nights.samples, kOptions).isAlarm();
        alarms += isAlarm && !wasAlarm;
        wasAlarm = isAlarm;
      }
    }
    EXPECT_LE(alarms, robots) << error;
  }
}

TEST(WatchErrors, aDeclineIsFoundWithinFiveNightsOfPassingTheLimit) {
  for (const int length : {10, 20, 40}) {
    int late = 0;
    const int robots = 100;
    for (unsigned seed = 0; seed < robots; ++seed) {
      // The odometry decays from the 20th night on, and the limit is passed `length` nights later.
      Nights nights(seed, [&](int night) {
        return 0.1 + std::max(0, night - 20) * (kOptions.limit - 0.1) / length;
      });
      bool isFound = false;
      for (int night = 0; night <= 20 + length + 5; ++night) {
        nights.add();
        isFound = isFound || (night > 20 && watchErrors(nights.samples, kOptions).isAlarm());
      }
      late += !isFound;
    }
    EXPECT_LE(late, 2) << length;
  }
}

}  // namespace
}  // namespace roomgraph
