#pragma once
#include "roomgraph/align/NarrowingBand.h"
#include "roomgraph/align/nearest_wall.h"

namespace roomgraph {

/** How closely a pose of two maps is looked at. */
struct Look {
  NarrowingBand band;    ///< of the fit
  int refinePoints = 0;  ///< wall points of each map that are laid on the other's, evenly
  double noise = 0;      ///< how far apart the same wall lies in good maps [m]
  int verifyPoints = 0;  ///< wall points of each map that are looked up in the other at last
};

// `benchmarks/alignment_accuracy --data DIR` judges them.
constexpr Look kGlance{{0.6, 0.4, 4}, 100, 0.2, 150};      ///< at each hypothesis
constexpr Look kSecondLook{{0.4, 0.3, 3}, 250, 0.2, 400};  ///< at the best of them
/** For a pose that is to be as good as it can be. */
constexpr Look kCloseLook{{0.6, 0.25, 12}, 400, kWallNoise, 1000};

}  // namespace roomgraph
