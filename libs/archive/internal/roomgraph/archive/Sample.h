#pragma once
#include <vector>

namespace roomgraph {

/** A figure, and when it was taken. */
struct Sample {
  double time = 0;  ///< [days]
  double value = 0;
};

/** In the order of time. */
using Samples = std::vector<Sample>;

}  // namespace roomgraph
