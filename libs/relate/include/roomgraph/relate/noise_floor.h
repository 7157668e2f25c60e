#pragma once
#include "roomgraph/align/MapForAlignment.h"
#include "roomgraph/grid/add_wall_noise.h"

namespace roomgraph {

// Ours, with the noise of the paper (IV-C)
// In:   the grid of a run
// Out:  the bend that noise alone makes
// Next: scoreRuns

struct NoiseFloorOptions {
  WallNoise noise{5, 2, 1};  ///< the paper's base map: 2 % of the walls, up to 5 cells away
  int repeats = 3;           ///< with other seeds
};

/** How far a map bends away from itself when its walls are noisy, as a root mean square over the
 *  repeats [m]: bends of this size between two runs say nothing. 0 for a map without walls.
 *  O(repeats * mapForAlignment). */
double noiseFloor(const Grid& grid, const MapForAlignment& map, const NoiseFloorOptions& options);

}  // namespace roomgraph
