#pragma once
#include <cstddef>
#include <optional>
#include <vector>

namespace roomgraph {

/** A figure, and when it was taken. */
struct Sample {
  double time = 0;  ///< [days]
  double value = 0;
};

/** In the order of time. */
using Samples = std::vector<Sample>;

// Mann 1945, Kendall 1975

/** How likely values without a trend rise as much as these do, 0 to 1: the test of Mann and Kendall
 *  with the normal approximation and the usual correction, which counts values that are the same.
 *  It asks for the order of the values alone, so one bad value weighs no more than any other.
 *  Samples must be in the order of time; fewer than three, or values that are all the same, have no
 *  trend: 0.5. O(samples^2). */
double mannKendall(const Samples& samples);

// Theil 1950, Sen 1968

/** A straight line through samples. */
struct SlopeFit {
  double perDay = 0;  ///< [unit of the values per day]
  double at0 = 0;     ///< at time 0

  double at(double time) const { return at0 + perDay * time; }
};

/** The line with the median of the slopes between all two samples, through the median of what it
 *  leaves over: up to 29 % of the samples may be far off without moving it far. Pairs of the same
 *  time have no slope. Nothing where no two samples differ in time. O(samples^2). */
std::optional<SlopeFit> theilSen(const Samples& samples);

// CUSUM of ranks: Pettitt 1979

/** Where values change their level. */
struct ChangePoint {
  std::size_t first = 0;         ///< index of the first sample behind it, at least 1
  double before = 0, after = 0;  ///< medians
  double p = 1;                  ///< how likely values without a change look like this, 0 to 1
};

/** Where the cumulative sum of the ranks' deviations from their mean is farthest from nought; of
 *  equal ones the first. The ranks instead of the values: one bad night is no change. The
 *  probability is Pettitt's approximation, which is on the safe side. Nothing where all values are
 *  the same, or there are fewer than two. O(samples log samples). */
std::optional<ChangePoint> changePoint(const Samples& samples);

// In:   the map errors of a robot in one site, night by night
// Out:  ErrorWatch
// Next: watchSite

/** Nights whose median is held against the limit, and in which a decline is looked for. */
constexpr std::size_t kLastNights = 5, kDeclineNights = 30;

struct WatchOptions {
  double limit = 0.3;        ///< map error that is still good enough [m]
  std::size_t history = 90;  ///< nights in which a change is looked for
};

/** What the map errors say of a robot. */
struct ErrorWatch {
  bool isOverLimit = false;           ///< the median of the last nights is above the limit
  bool isDeclining = false;           ///< the errors rise, slowly or not, and surely
  bool isChanged = false;             ///< they have been larger since some night, and surely
  bool isTooShort = true;             ///< too few samples to see a decline or a change
  std::optional<SlopeFit> slope;      ///< of the last kDeclineNights
  double pRising = 0.5;               ///< of these, see mannKendall
  std::optional<ChangePoint> change;  ///< of the history; its index is one of all samples
  std::optional<double> daysToLimit;  ///< where it is declining and below the limit

  bool isAlarm() const { return isOverLimit || isDeclining || isChanged; }
};

/** Judges the map errors [m] of a robot, in the order of time. One bad night, or two in five, are
 *  no alarm, a slow decline is. With fewer than kLastNights samples nothing is said, with fewer
 *  than twice as many nothing of a decline or a change. O(history log history). */
ErrorWatch watchErrors(const Samples& errors, const WatchOptions& options);

}  // namespace roomgraph
