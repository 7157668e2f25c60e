#pragma once
#include <functional>

#include "roomgraph/base/Notes.h"
#include "roomgraph/base/Options.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

// Paper III-A, the end
// In:   TopologyGraph, and the regions that are worth a way
// Out:  TopologyGraph
// Next: borderVertices

struct KeepComponentsOptions {
  bool onlyLargest = false;  ///< as the paper does
};
void describe(KeepComponentsOptions& options, FieldTable& table);

using RegionAt = std::function<RoomId(Point)>;  ///< the region at a place, or none [m]

/** Keeps the connected component with the largest total path length (where all are 0, the one with
 *  the widest place); unless only that is wanted, also each other one that leads into a region that
 *  no longer one leads into, as behind a closed door. What is dropped is told in `notes` (code
 *  "component_dropped"). O(n), and of the same order of calls to `regionAt` where there are several
 *  components. */
[[nodiscard]] TopologyGraph keepComponents(TopologyGraph graph, const RegionAt& regionAt,
                                           const KeepComponentsOptions& options, Notes& notes);

}  // namespace roomgraph
