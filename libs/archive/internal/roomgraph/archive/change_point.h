#pragma once
#include <cstddef>
#include <optional>

#include "roomgraph/archive/Sample.h"

namespace roomgraph {

// CUSUM of ranks: Pettitt 1979
// In:   Samples
// Out:  ChangePoint
// Next: watchErrors

/** Where values change their level. */
struct ChangePoint {
  std::size_t first = 0;         ///< index of the first sample behind it, at least 1
  double before = 0, after = 0;  ///< medians
  double p = 1;                  ///< how likely values without a change look like this, 0 to 1
};

/** Where the cumulative sum of the ranks' deviations from their mean is farthest from nought; of
 *  equal ones the first. The ranks instead of the values: one bad night is no change. The
 *  probability is Pettitt's approximation, which is on the safe side. Nothing where all values are
 *  the same, or there are fewer than two. O(samples log samples). */
std::optional<ChangePoint> changePoint(const Samples& samples);

}  // namespace roomgraph
