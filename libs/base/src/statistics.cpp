#include "roomgraph/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace roomgraph {

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double place = share * double(values.size() - 1);
  const auto low = std::size_t(place);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  const double upper = place - std::floor(place);
  return (1 - upper) * values[low] + upper * values[high];
}

double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

std::optional<double> weightedQuantile(std::vector<WeightedValue> values, double share) {
  constexpr double kRounding = 1e-12;  // of sums of weights
  std::sort(values.begin(), values.end(), [](const WeightedValue& l, const WeightedValue& r) {
    return std::tie(l.value, l.weight) < std::tie(r.value, r.weight);
  });
  double all = 0, upToHere = 0;
  for (const WeightedValue& v : values) all += v.weight;
  std::optional<double> lower;
  for (const WeightedValue& v : values) {
    if (v.weight <= 0) continue;
    if (lower) return (*lower + v.value) / 2;
    upToHere += v.weight;
    if (upToHere > (share + kRounding) * all) return v.value;
    if (upToHere >= (share - kRounding) * all) lower = v.value;
  }
  return lower;
}

std::optional<double> weightedMedian(std::vector<WeightedValue> values) {
  return weightedQuantile(std::move(values), 0.5);
}

}  // namespace roomgraph
