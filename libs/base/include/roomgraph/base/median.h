#pragma once
#include <algorithm>
#include <vector>

namespace roomgraph {

/** The middle value, or the mean of the two in the middle. `values` must not be empty.
 *  O(n log n). */
inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

}  // namespace roomgraph
