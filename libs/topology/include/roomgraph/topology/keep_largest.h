#pragma once
#include "roomgraph/base/Notes.h"
#include "roomgraph/base/Options.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

// Paper III-A, the end
// In:   TopologyGraph
// Out:  TopologyGraph
// Next: findRooms, borderVertices

struct KeepLargestOptions {
  bool allComponents = false;  ///< keep the unconnected ones, too
  double minLength = 1.0;      ///< of the paths of a component that is kept beside the largest [m]
};
void describe(KeepLargestOptions& options, FieldTable& table);

/** Keeps the connected part with the largest total path length; where all are 0, the one with the
 *  widest place. With `allComponents`, keeps all from `minLength` up and the largest. What is
 *  dropped is told in `notes` (code "component_dropped"). O(n). */
[[nodiscard]] TopologyGraph keepLargest(TopologyGraph graph, const KeepLargestOptions& options,
                                        Notes& notes);

}  // namespace roomgraph
