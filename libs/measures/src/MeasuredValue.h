#pragma once
#include <optional>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** What a measure comes to; its kind says what it is. */
struct MeasuredValue {
  std::optional<double> value{};  ///< none where nothing supports it
  double support = 0;             ///< how many things were counted
  std::optional<double> low{}, high{};
  bool hasEnoughOthers = true;
  double worth = 1;              ///< of each, in those that MeasureKind::leastSupport counts
  std::optional<Point> place{};  ///< see Measure [m, map frame of the run]
};

}  // namespace roomgraph
