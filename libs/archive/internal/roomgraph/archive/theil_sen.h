#pragma once
#include <optional>

#include "roomgraph/archive/Sample.h"

namespace roomgraph {

// Theil 1950, Sen 1968
// In:   Samples
// Out:  SlopeFit
// Next: watchErrors

/** A straight line through samples. */
struct SlopeFit {
  double perDay = 0;  ///< [unit of the values per day]
  double at0 = 0;     ///< at time 0

  double at(double time) const { return at0 + perDay * time; }
};

/** The line with the median of the slopes between all two samples, through the median of what it
 *  leaves over: up to 29 % of the samples may be far off without moving it far. Pairs of the same
 *  time have no slope. Nothing where no two samples differ in time. O(samples^2). */
std::optional<SlopeFit> theilSen(const Samples& samples);

}  // namespace roomgraph
