#pragma once
#include <algorithm>
#include <optional>
#include <vector>

namespace roomgraph {

/** The middle value, or the mean of the two in the middle. `values` must not be empty.
 *  O(n log n). */
inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

struct WeightedValue {
  double value = 0;
  double weight = 0;  ///< at least 0
};

/** The least value up to which half of the weight lies; nothing where there is no weight.
 *  O(n log n). */
inline std::optional<double> weightedMedian(std::vector<WeightedValue> values) {
  std::stable_sort(values.begin(), values.end(),
                   [](const auto& l, const auto& r) { return l.value < r.value; });
  double all = 0, below = 0;
  for (const WeightedValue& v : values) all += v.weight;
  for (const WeightedValue& v : values) {
    below += v.weight;
    if (v.weight > 0 && 2 * below >= all) return v.value;
  }
  return std::nullopt;
}

}  // namespace roomgraph
