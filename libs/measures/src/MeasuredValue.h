#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** What a measure comes to; its kind says what it is. */
struct MeasuredValue {
  std::optional<double> value{};  ///< none where nothing supports it
  double support = 0;             ///< how many things were counted
  std::optional<double> low{}, high{};
  bool hasEnoughOthers = true;
  double worth = 1;              ///< of each, in those that MeasureKind::leastSupport counts
  std::optional<Point> place{};  ///< see Measure [m, map frame of the run]
};

/** What a run is by the others: its value, the range of the value when any one of them is left out,
 *  and the support; there are enough of them from kFewestOthers on. `supports` says how much each
 *  other run supports, 0 for the run itself and for those that have nothing to say.
 *  `valueWithout(i)` leaves other i out, or none where i is the number of runs. */
MeasuredValue measureOverOthers(
    const std::vector<double>& supports,
    const std::function<std::optional<double>(std::size_t)>& valueWithout);

/** What one other run says of a share: a part of a whole, both weighted. */
struct ShareInOther {
  double support = 0, part = 0, whole = 0;
};

/** The same for the sum of all parts over that of the wholes; none where there is no whole. */
MeasuredValue shareOverOthers(const std::vector<ShareInOther>& others);

}  // namespace roomgraph
