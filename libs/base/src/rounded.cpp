#include "roomgraph/base/rounded.h"

#include <cmath>

namespace roomgraph {

double rounded(double value) {
  constexpr double kPerMetre = 1e4;
  return std::round(value * kPerMetre) / kPerMetre + 0.0;
}

}  // namespace roomgraph
