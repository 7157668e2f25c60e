#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "MeasuredValue.h"

namespace roomgraph {

/** What a run is by the others: its value, the range of the value when any one of them is left out,
 *  and the support; there are enough of them from kFewestOthers on. `supports` says how much each
 *  other run supports, 0 for the run itself and for those that have nothing to say.
 *  `valueWithout(i)` leaves other i out, or none where i is the number of runs. */
MeasuredValue measureOverOthers(
    const std::vector<double>& supports,
    const std::function<std::optional<double>(std::size_t)>& valueWithout);

}  // namespace roomgraph
