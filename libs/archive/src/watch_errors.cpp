#include "roomgraph/archive/watch_errors.h"

#include <algorithm>

#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

Samples lastOf(const Samples& samples, std::size_t count) {
  return {samples.end() - std::ptrdiff_t(std::min(count, samples.size())), samples.end()};
}

double medianOf(const Samples& samples) {
  std::vector<double> values;
  for (const Sample& sample : samples) values.push_back(sample.value);
  return median(std::move(values));
}

/** More than moved furniture and chance would do. */
bool isWorse(double before, double after, const WatchOptions& options) {
  return after - before >= std::max(options.leastMetres, options.leastRise * before);
}

void findDecline(ErrorWatch& watch, const Samples& errors, const WatchOptions& options) {
  const Samples window = lastOf(errors, options.window);
  watch.slope = theilSen(window);
  watch.trend = mannKendall(window);
  if (!watch.slope || watch.trend.pRising >= options.surely) return;
  const double start = std::max(0.0, watch.slope->at(window.front().time));
  const double now = watch.slope->at(window.back().time);
  watch.isDeclining = isWorse(start, now, options);
  if (watch.isDeclining && now < options.limit)
    watch.daysToLimit = (options.limit - now) / watch.slope->perDay;
}

void findChange(ErrorWatch& watch, const Samples& errors, const WatchOptions& options) {
  const Samples history = lastOf(errors, options.history);
  watch.change = changePoint(history);
  if (!watch.change) return;
  watch.change->first += errors.size() - history.size();
  // What has been mended since is no change for the worse.
  const double now = medianOf(lastOf(errors, options.nights));
  watch.isChanged = watch.change->p < options.surely &&
                    isWorse(watch.change->before, std::min(now, watch.change->after), options);
}

}  // namespace

ErrorWatch watchErrors(const Samples& errors, const WatchOptions& options) {
  ErrorWatch watch;
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (errors[i].value <= options.limit) watch.lastGood = i;
  if (errors.size() < options.nights) return watch;
  watch.isOverLimit = medianOf(lastOf(errors, options.nights)) > options.limit;
  watch.isTooShort = errors.size() < 2 * options.nights;
  if (watch.isTooShort) return watch;
  findDecline(watch, errors, options);
  findChange(watch, errors, options);
  return watch;
}

}  // namespace roomgraph
