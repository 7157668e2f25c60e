#include "roomgraph/archive/change_point.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

/** From 1 on; equal values have the mean of their ranks. */
std::vector<double> ranksOf(const Samples& samples) {
  std::vector<double> sorted, ranks;
  for (const Sample& sample : samples) sorted.push_back(sample.value);
  std::sort(sorted.begin(), sorted.end());
  for (const Sample& sample : samples) {
    const auto [low, high] = std::equal_range(sorted.begin(), sorted.end(), sample.value);
    ranks.push_back(double(low - sorted.begin() + (high - sorted.begin()) + 1) / 2);
  }
  return ranks;
}

double medianOf(const Samples& samples, std::size_t begin, std::size_t end) {
  std::vector<double> values;
  for (std::size_t i = begin; i < end; ++i) values.push_back(samples[i].value);
  return median(std::move(values));
}

}  // namespace

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
  found.before = medianOf(samples, 0, found.first);
  found.after = medianOf(samples, found.first, samples.size());
  // Pettitt's K is twice the cumulative sum of the ranks.
  found.p = std::min(1.0, 2 * std::exp(-6 * 4 * most * most / (n * n * n + n * n)));
  return found;
}

}  // namespace roomgraph
