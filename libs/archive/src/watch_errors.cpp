#include "roomgraph/archive/watch_errors.h"

#include <algorithm>

namespace roomgraph {
namespace {

constexpr double kSurely = 0.0005;  // probability below which a trend or a change is none of chance
constexpr double kLeastRise = 0.3;  // as a share of the level before; less is no decline
constexpr double kLeastMetres = 0.03;  // less is no decline, either [m]

Samples lastOf(const Samples& samples, std::size_t count) {
  return {samples.end() - std::ptrdiff_t(std::min(count, samples.size())), samples.end()};
}

/** More than moved furniture and chance would do. */
bool isWorse(double before, double after) {
  return after - before >= std::max(kLeastMetres, kLeastRise * before);
}

void findDecline(ErrorWatch& watch, const Samples& errors, const WatchOptions& options) {
  const Samples window = lastOf(errors, kDeclineNights);
  watch.slope = theilSen(window);
  watch.trend = mannKendall(window);
  if (!watch.slope || watch.trend.pRising >= kSurely) return;
  const double start = std::max(0.0, watch.slope->at(window.front().time));
  const double now = watch.slope->at(window.back().time);
  watch.isDeclining = isWorse(start, now);
  if (watch.isDeclining && now < options.limit)
    watch.daysToLimit = (options.limit - now) / watch.slope->perDay;
}

void findChange(ErrorWatch& watch, const Samples& errors, const WatchOptions& options) {
  const Samples history = lastOf(errors, options.history);
  watch.change = changePoint(history);
  if (!watch.change) return;
  watch.change->first += errors.size() - history.size();
  // What has been mended since is no change for the worse.
  const double now = medianOf(lastOf(errors, kLastNights));
  watch.isChanged = watch.change->p < kSurely &&
                    isWorse(watch.change->before, std::min(now, watch.change->after));
}

}  // namespace

ErrorWatch watchErrors(const Samples& errors, const WatchOptions& options) {
  ErrorWatch watch;
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (errors[i].value <= options.limit) watch.lastGood = i;
  if (errors.size() < kLastNights) return watch;
  watch.isOverLimit = medianOf(lastOf(errors, kLastNights)) > options.limit;
  watch.isTooShort = errors.size() < 2 * kLastNights;
  if (watch.isTooShort) return watch;
  findDecline(watch, errors, options);
  findChange(watch, errors, options);
  return watch;
}

}  // namespace roomgraph
