#include "measure_over_others.h"

#include <algorithm>
#include <numeric>

#include "roomgraph/measures/measure_kinds.h"

namespace roomgraph {

constexpr std::size_t kMinOthers = 2;

void measureOverOthers(Measure& measure, const std::vector<double>& supports,
                       const std::function<std::optional<double>(std::size_t)>& valueWithout) {
  const std::size_t others =
      supports.size() - std::size_t(std::count(supports.begin(), supports.end(), 0.0));
  if (others == 0) return;
  measure.support = std::accumulate(supports.begin(), supports.end(), 0.0);
  measure.value = valueWithout(supports.size());
  measure.isMeaningful = measure.value && others >= kMinOthers &&
                         measure.support >= findMeasureKind(measure.name)->leastSupport;
  if (others > 1) measure.low = measure.high = measure.value;
  for (std::size_t j = 0; others > 1 && j < supports.size(); ++j) {
    if (supports[j] == 0) continue;
    const std::optional<double> without = valueWithout(j);
    if (!without) continue;
    measure.low = std::min(measure.low.value_or(*without), *without);
    measure.high = std::max(measure.high.value_or(*without), *without);
  }
}

}  // namespace roomgraph
