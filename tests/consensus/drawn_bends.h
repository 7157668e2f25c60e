#pragma once
#include <cmath>
#include <vector>

#include "roomgraph/relate/PairBend.h"

namespace roomgraph::test {

/** The bends of maps that each err in their own way. */
inline PairBends bendsOf(const std::vector<double>& errors) {
  PairBends bends(errors.size());
  for (const auto& [i, j] : bends.pairs())
    bends(i, j) = {std::hypot(errors[i], errors[j]), 1, 1000, false};
  return bends;
}

}  // namespace roomgraph::test
