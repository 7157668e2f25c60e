#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/base/Options.h"
#include "roomgraph/topology/VoronoiGraph.h"
#include "roomgraph/topology/keep_inside.h"

namespace roomgraph {

// Paper III-A: "filtering out edges too close to an obstacle cell"
// In:   VoronoiGraph and what of it lies inside
// Out:  the indices of the edges that are kept, ascending
// Next: dropHalfSeen

using EdgeIndices = std::vector<std::uint32_t>;  ///< places in VoronoiGraph::edges, ascending

struct KeepClearOptions {
  double minClearance = 0.2;  ///< of every place on a kept edge [m]
};
void describe(KeepClearOptions& options, FieldTable& table);

/** The clearance that is really applied [m]: at least 0.75 cells, and a little less than asked
 *  for, so that no rounding decides on passages of just the least width. An edge that keeps this
 *  far from the centres of all obstacle cells cannot pass between two cells of a wall, nor touch
 *  one. */
[[nodiscard]] double effectiveClearance(const KeepClearOptions& options, double resolution);

/** The finite edges inside whose every place keeps at least `clearance` metres from all obstacles.
 *  Two places that a disc of this radius can move between stay connected: moving away from the
 *  nearest obstacle leads from any place to a kept edge, and never nearer to an obstacle. O(n). */
[[nodiscard]] EdgeIndices keepClear(const VoronoiGraph& graph, const InsideFlags& isInside,
                                    double clearance);

}  // namespace roomgraph
