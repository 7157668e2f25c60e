#pragma once
#include "roomgraph/base/Options.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

// Ours: the paper leaves two border vertices in every door between two rooms
// In:   TopologyGraph with rooms cut out
// Out:  TopologyGraph
// Next: roomGraph

struct JoinDoorsOptions {
  double maxDepth =
      1.0;  ///< of the way through a door, about the wall's thickness; 0 for never [m]
};
void describe(JoinDoorsOptions& options, FieldTable& table);

/** A corridor up to `maxDepth` long that does nothing but join two rooms is a door: it and its two
 *  border vertices become one border vertex, in its middle, that both rooms share: it lies up to
 *  half of `maxDepth` off their rings. Whether a wall is one cell thick or two then makes no
 *  difference to the graph. O(n). */
[[nodiscard]] TopologyGraph joinDoors(TopologyGraph graph, const JoinDoorsOptions& options);

}  // namespace roomgraph
