#pragma once
#include <algorithm>
#include <cstddef>

#include "roomgraph/relate/PairBend.h"

namespace roomgraph {

/** The largest share of its walls that a run has in common with another. */
inline double mostShare(const PairBends& bends, std::size_t run) {
  double most = 0;
  for (const std::size_t j : bends.othersOf(run)) most = std::max(most, bends(run, j).share);
  return most;
}

}  // namespace roomgraph
