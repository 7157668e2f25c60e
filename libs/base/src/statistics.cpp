#include "roomgraph/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace roomgraph {

namespace {

/** The least value up to which at least `share` of the weight lies, and the least one up to which
 *  more does: the same but where exactly that much lies up to the first. */
std::optional<std::pair<double, double>> weightedBounds(std::vector<WeightedValue> values,
                                                        double share) {
  constexpr double rounding = 1e-12;  // of sums of weights
  std::sort(values.begin(), values.end(), [](const WeightedValue& l, const WeightedValue& r) {
    return std::tie(l.value, l.weight) < std::tie(r.value, r.weight);
  });
  double all = 0, upToHere = 0;
  for (const WeightedValue& v : values) all += v.weight;
  std::optional<double> lower;
  for (const WeightedValue& v : values) {
    if (v.weight <= 0) continue;
    if (lower) return std::pair(*lower, v.value);
    upToHere += v.weight;
    if (upToHere > (share + rounding) * all) return std::pair(v.value, v.value);
    if (upToHere >= (share - rounding) * all) lower = v.value;
  }
  if (!lower) return std::nullopt;
  return std::pair(*lower, *lower);
}

}  // namespace

double quantile(std::vector<double> values, double share) {
  const double place = share * double(values.size() - 1), low = std::floor(place);
  const auto lower = values.begin() + std::ptrdiff_t(low), next = lower + 1;
  std::nth_element(values.begin(), lower, values.end());
  const double upper = next == values.end() ? *lower : *std::min_element(next, values.end());
  return (1 - (place - low)) * *lower + (place - low) * upper;
}

double lowerQuantile(std::vector<double> values, double share) {
  const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

std::optional<double> weightedQuantile(std::vector<WeightedValue> values, double share) {
  const auto bounds = weightedBounds(std::move(values), share);
  if (!bounds) return std::nullopt;
  return (bounds->first + bounds->second) / 2;
}

std::optional<double> weightedMedian(std::vector<WeightedValue> values) {
  return weightedQuantile(std::move(values), 0.5);
}

std::optional<double> lowerWeightedMedian(std::vector<WeightedValue> values) {
  const auto bounds = weightedBounds(std::move(values), 0.5);
  if (!bounds) return std::nullopt;
  return bounds->first;
}

}  // namespace roomgraph
