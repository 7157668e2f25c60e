#pragma once
#include <algorithm>
#include <vector>

#include "roomgraph/relate/PairBend.h"

namespace roomgraph {

/** The largest share of its walls that a run has in common with another, of its row of pairs. */
inline double mostShare(const std::vector<PairBend>& pairs) {
  double most = 0;
  for (const PairBend& pair : pairs) most = std::max(most, pair.share);
  return most;
}

}  // namespace roomgraph
