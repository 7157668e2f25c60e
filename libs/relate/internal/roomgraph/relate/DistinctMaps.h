#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/relate/PairBend.h"

namespace roomgraph {

/** Which runs have the same map: a copy is no further witness. */
class DistinctMaps {
 public:
  explicit DistinctMaps(const PairBends& bends) {
    for (std::size_t i = 0; i < bends.things(); ++i) {
      std::size_t first = i;
      for (const std::size_t j : bends.othersOf(i))
        if (j < first && bends(i, j).areIdentical) first = j;
      first_.push_back(first);
      count_ += first == i;
    }
  }

  /** The first run that has the same map as this one: itself, if none before it has. */
  std::size_t firstOf(std::size_t run) const { return first_[run]; }
  bool isFirst(std::size_t run) const { return first_[run] == run; }

  std::size_t count() const { return count_; }

  /** Whether a run is measured against another one: against one run of each map, and against
   *  copies of its own only where there is no other map. */
  bool isMeasuredAgainst(std::size_t run, std::size_t other) const {
    if (count_ == 1) return run != other;
    return isFirst(other) && firstOf(run) != other;
  }

 private:
  std::vector<std::size_t> first_;
  std::size_t count_ = 0;
};

}  // namespace roomgraph
