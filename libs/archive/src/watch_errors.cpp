#include "roomgraph/archive/watch_errors.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

int signOf(double value) { return (value > 0) - (value < 0); }

/** Of the sum of signs, where there is no trend; groups of equal values have less of it. */
double varianceOf(const Samples& samples) {
  const auto term = [](double n) { return n * (n - 1) * (2 * n + 5) / 18; };
  std::map<double, double> times;
  for (const Sample& sample : samples) ++times[sample.value];
  double variance = term(double(samples.size()));
  for (const auto& [value, count] : times) variance -= term(count);
  return variance;
}

/** From 1 on; equal values have the mean of their ranks. */
std::vector<double> ranksOf(const Samples& samples) {
  std::vector<double> sorted = mapped(samples, &Sample::value), ranks;
  std::sort(sorted.begin(), sorted.end());
  for (const Sample& sample : samples) {
    const auto [low, high] = std::equal_range(sorted.begin(), sorted.end(), sample.value);
    ranks.push_back(double(low - sorted.begin() + (high - sorted.begin()) + 1) / 2);
  }
  return ranks;
}

constexpr double kSurely = 0.0005;  // probability below which a trend or a change is none of chance
constexpr double kLeastRise = 0.3;  // as a share of the level before; less is no decline
constexpr double kLeastMetres = 0.03;  // less is no decline, either [m]

Samples lastOf(const Samples& samples, std::size_t count) {
  return {samples.end() - std::ptrdiff_t(std::min(count, samples.size())), samples.end()};
}

/** Of the values, of which there must be one. */
double medianOf(const Samples& samples) { return median(mapped(samples, &Sample::value)); }

/** More than moved furniture and chance would do. */
bool isWorse(double before, double after) {
  return after - before >= std::max(kLeastMetres, kLeastRise * before);
}

void findDecline(ErrorWatch& watch, const Samples& errors, const WatchOptions& options) {
  const Samples window = lastOf(errors, kDeclineNights);
  watch.slope = theilSen(window);
  watch.pRising = mannKendall(window);
  if (!watch.slope || watch.pRising >= kSurely) return;
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

double mannKendall(const Samples& samples) {
  const double variance = varianceOf(samples);
  if (samples.size() < 3 || variance <= 0) return 0.5;
  int sum = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t j = i + 1; j < samples.size(); ++j)
      sum += signOf(samples[j].value - samples[i].value);
  // The sum moves in steps of two, hence the one.
  const double z = (sum - signOf(sum)) / std::sqrt(variance);
  return 0.5 * std::erfc(z / std::sqrt(2.0));
}

std::optional<SlopeFit> theilSen(const Samples& samples) {
  std::vector<double> slopes;
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t j = i + 1; j < samples.size(); ++j)
      if (samples[i].time != samples[j].time)
        slopes.push_back((samples[j].value - samples[i].value) /
                         (samples[j].time - samples[i].time));
  if (slopes.empty()) return {};
  SlopeFit fit;
  fit.perDay = median(std::move(slopes));
  fit.at0 = median(mapped(samples, [&](const Sample& s) { return s.value - fit.perDay * s.time; }));
  return fit;
}

std::optional<ChangePoint> changePoint(const Samples& samples) {
  const std::vector<double> ranks = ranksOf(samples);
  const double n = double(ranks.size());
  double sum = 0, most = 0;
  ChangePoint found;
  for (std::size_t i = 0; i + 1 < ranks.size(); ++i) {
    sum += ranks[i] - (n + 1) / 2;
    if (std::abs(sum) > most) most = std::abs(sum), found.first = i + 1;
  }
  if (most == 0) return {};
  const auto change = samples.begin() + std::ptrdiff_t(found.first);
  found.before = medianOf({samples.begin(), change});
  found.after = medianOf({change, samples.end()});
  // Pettitt's K is twice the cumulative sum of the ranks.
  found.p = std::min(1.0, 2 * std::exp(-6 * 4 * most * most / (n * n * n + n * n)));
  return found;
}

ErrorWatch watchErrors(const Samples& errors, const WatchOptions& options) {
  ErrorWatch watch;
  if (errors.size() < kLastNights) return watch;
  watch.isOverLimit = medianOf(lastOf(errors, kLastNights)) > options.limit;
  watch.isTooShort = errors.size() < 2 * kLastNights;
  if (watch.isTooShort) return watch;
  findDecline(watch, errors, options);
  findChange(watch, errors, options);
  return watch;
}

}  // namespace roomgraph
