#pragma once
#include <cmath>

namespace roomgraph {

/** The band around a wall in which others count, for a fit in several steps: wide at first, so that
 *  what lies far off is pulled in, and from step to step narrower by the same factor. */
struct NarrowingBand {
  double first = 0, last = 0;  ///< [m]
  int steps = 1;

  double widthAt(int step) const {
    const double share = steps > 1 ? double(step) / (steps - 1) : 1;
    return first * std::pow(last / first, share);
  }

  /** The first half of the steps (0), or the second (1); of an even number. */
  NarrowingBand half(int which) const {
    const int from = which * steps / 2;
    return {widthAt(from), widthAt(from + steps / 2 - 1), steps / 2};
  }
};

}  // namespace roomgraph
