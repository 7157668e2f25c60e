#pragma once
#include "roomgraph/base/Options.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

// Paper III-A: "the vertices which are very close to each other are merged"
// In:   TopologyGraph
// Out:  TopologyGraph
// Next: keepComponents

struct JoinVerticesOptions {
  double maxDistance = 0.2;  ///< along the path [m]
  double maxDistancePx = 0;  ///< the same in cells [px]; 0 for maxDistance
};
void describe(JoinVerticesOptions& options, FieldTable& table);

/** Joins vertices that paths up to the limit connect, also over several of them, into the one
 *  nearest to their mean; the tips of dead ends stay. Paths are led on along the joined ones, so
 *  that they keep their clearance. A path round an obstacle whose ends are joined becomes a self
 *  loop. O(n log n). */
[[nodiscard]] TopologyGraph joinVertices(TopologyGraph graph, const JoinVerticesOptions& options,
                                         double resolution);

}  // namespace roomgraph
