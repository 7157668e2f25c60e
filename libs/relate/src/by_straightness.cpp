#include "by_straightness.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace roomgraph {

std::vector<std::size_t> byStraightness(const std::vector<Run>& runs) {
  double largest = 0;
  for (const Run& run : runs) largest = std::max(largest, run.map.freeArea);
  std::vector<std::size_t> order(runs.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto key = [&](std::size_t i) {
    return std::make_pair(runs[i].map.freeArea < largest / 2,
                          runs[i].map.axisDeviation.value_or(M_PI));
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t l, std::size_t r) { return key(l) < key(r); });
  return order;
}

}  // namespace roomgraph
