#pragma once
#include <cstddef>
#include <optional>

#include "roomgraph/archive/Samples.h"

namespace roomgraph {

// Ours
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
  bool isOverLimit = false;             ///< the median of the last nights is above the limit
  bool isDeclining = false;             ///< the errors rise, slowly or not, and surely
  bool isChanged = false;               ///< they have been larger since some night, and surely
  bool isTooShort = true;               ///< too few samples to see a decline or a change
  std::optional<SlopeFit> slope;        ///< of the last kDeclineNights
  TrendTest trend;                      ///< of these
  std::optional<ChangePoint> change;    ///< of the history; its index is one of all samples
  std::optional<double> daysToLimit;    ///< where it is declining and below the limit
  std::optional<std::size_t> lastGood;  ///< the last sample that is not above the limit

  bool isAlarm() const { return isOverLimit || isDeclining || isChanged; }
};

/** Judges the map errors [m] of a robot, in the order of time. One bad night, or two in five, are
 *  no alarm, a slow decline is. With fewer than kLastNights samples nothing is said but lastGood,
 *  with fewer than twice as many nothing of a decline or a change. O(history log history). */
ErrorWatch watchErrors(const Samples& errors, const WatchOptions& options);

}  // namespace roomgraph
