#pragma once
#include <cstdint>

#include "roomgraph/grid/Grid.h"

namespace roomgraph {

// Paper IV-C: "several versions of each map with random noise near the walls"
// In:   Grid
// Out:  Grid
// Next: thinObstacles

struct WallNoise {
  int maxDistance = 0;     ///< the paper's d_r: of a new cell from an old one, per axis [px]
  double percent = 0;      ///< the paper's p: share of the occupied cells that move, 0 to 100
  std::uint64_t seed = 0;  ///< of the random numbers
};

/** Frees `percent` of the occupied cells, and occupies as many others: each lies at most
 *  `maxDistance` columns and as many rows away from a random cell that was occupied in `grid`, and
 *  is one that is not occupied by then, free or unknown. All such places are equally likely for a
 *  given old cell, and each choice is made anew until it hits one. So the number of occupied cells
 *  stays, unknown cells may become walls, and a cell that was freed may be taken again.
 *  The same arguments give the same grid on every machine. Expected O(cells), longer where next to
 *  all cells are occupied. Throws UsageError for a share outside of 0 to 100 or a negative
 *  distance. */
[[nodiscard]] Grid addWallNoise(const Grid& grid, const WallNoise& noise);

}  // namespace roomgraph
