#include "MeasuredValue.h"

#include <algorithm>
#include <numeric>

#include "roomgraph/base/sequences.h"
#include "roomgraph/relate/PairBend.h"

namespace roomgraph {

MeasuredValue measureOverOthers(
    const std::vector<double>& supports,
    const std::function<std::optional<double>(std::size_t)>& valueWithout) {
  const std::size_t others =
      supports.size() - std::size_t(std::count(supports.begin(), supports.end(), 0.0));
  if (others == 0) return {};
  MeasuredValue measured;
  measured.support = std::accumulate(supports.begin(), supports.end(), 0.0);
  measured.value = valueWithout(supports.size());
  measured.hasEnoughOthers = others >= kFewestOthers;
  if (others > 1) measured.low = measured.high = measured.value;
  for (std::size_t j = 0; others > 1 && j < supports.size(); ++j) {
    if (supports[j] == 0) continue;
    const std::optional<double> without = valueWithout(j);
    if (!without) continue;
    measured.low = std::min(measured.low.value_or(*without), *without);
    measured.high = std::max(measured.high.value_or(*without), *without);
  }
  return measured;
}

MeasuredValue shareOverOthers(const std::vector<ShareInOther>& others) {
  const auto supports = mapped(others, &ShareInOther::support);
  return measureOverOthers(supports, [&](std::size_t but) -> std::optional<double> {
    double part = 0, whole = 0;
    for (std::size_t k = 0; k < others.size(); ++k)
      if (k != but) part += others[k].part, whole += others[k].whole;
    if (whole <= 0) return std::nullopt;
    return part / whole;
  });
}

}  // namespace roomgraph
