#pragma once
#include <optional>

namespace roomgraph {

/** A number, and from how many things it was made. */
struct Figure {
  std::optional<double> value;  ///< none where nothing supports it
  double support = 0;
};

}  // namespace roomgraph
