#pragma once
#include <optional>
#include <vector>

namespace roomgraph {

/** So many standard deviations either way hold 80 % of a normal distribution. */
constexpr double kEightyPercent = 1.2816;

/** The share, or the probability, from which on something is so rather than not: where nothing was
 *  fitted, as nothing speaks for another one. */
constexpr double kMajority = 0.5;

/** The value with `share` of the others below it, 0 to 1: between two neighbours in size on the
 *  straight line (type 7 of Hyndman and Fan, as numpy and R have it), so 0 is the least, 1 the
 *  largest, and quantile({1, 2, 4}, 0.75) is 3. `values` must not be empty. O(n). */
[[nodiscard]] double quantile(std::vector<double> values, double share);

/** The same, but one of the values: the lower of the two neighbours. O(n). */
[[nodiscard]] double lowerQuantile(std::vector<double> values, double share);

/** The quantile of one half: the middle value, or the mean of the two in the middle. */
[[nodiscard]] double median(std::vector<double> values);

struct WeightedValue {
  double value = 0;   ///< what is weighted
  double weight = 0;  ///< at least 0
};

/** The least value up to which more than `share` of the weight lies; where exactly that much lies
 *  up to a value, the mean of it and the next. Nothing where there is no weight. The order of
 *  `values` does not matter. O(n log n). */
[[nodiscard]] std::optional<double> weightedQuantile(std::vector<WeightedValue> values,
                                                     double share);

/** The weighted quantile of one half: the median where all weights are the same. */
[[nodiscard]] std::optional<double> weightedMedian(std::vector<WeightedValue> values);

/** The lower of the two values where that is the mean of two: for counts, which have no halves. */
[[nodiscard]] std::optional<double> lowerWeightedMedian(std::vector<WeightedValue> values);

}  // namespace roomgraph
