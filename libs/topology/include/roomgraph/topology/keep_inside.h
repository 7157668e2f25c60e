#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/base/Options.h"
#include "roomgraph/grid/Grid.h"
#include "roomgraph/topology/VoronoiGraph.h"

namespace roomgraph {

// Paper III and III-A: "the biggest Alpha Shape polygon ... to filter away the outside parts"
// In:   VoronoiGraph, Grid
// Out:  one flag per VoronoiVertex: non-zero lies inside
// Next: keepClear, findRooms

using InsideFlags = std::vector<std::uint8_t>;  ///< 1 for each vertex inside, else 0

struct KeepInsideOptions {
  double outsideWidth = 3.0;   ///< diameter of the disc that must not get in from outside [m]
  double outsideAlphaPx2 = 0;  ///< the same as alpha, its squared radius [px2]; 0 for outsideWidth
  bool biggestOnly = false;    ///< keep the biggest polygon only, as the paper does
  bool freeOnly = true;        ///< keep only what lies in free cells
};
void describe(KeepInsideOptions& options, FieldTable& table);

/** Outside is what a disc of `outsideWidth`, but of 1.5 cells at least, can reach from infinity
 *  without touching an obstacle: the complement of the alpha shape. With `freeOnly`, vertices in
 *  cells that are not free are outside, too. A vertex exactly between is outside. O(n). */
[[nodiscard]] InsideFlags keepInside(const VoronoiGraph& graph, const Grid& grid,
                                     const KeepInsideOptions& options);

}  // namespace roomgraph
