#pragma once
#include "roomgraph/base/Options.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

// Paper III-E, case B, and III-F
// In:   TopologyGraph, cut, with room ids
// Out:  TopologyGraph
// Next: roomGraph

struct ShortDeadEndsOptions {
  double minLength = 1.0;  ///< the paper's minLenThreshold [m]
  double minLengthPx = 0;  ///< the same in cells [px]; 0 for minLength
};
void describe(ShortDeadEndsOptions& options, FieldTable& table);

/** The limit that is applied [m]. */
[[nodiscard]] double shortLength(const ShortDeadEndsOptions& options, double resolution);

/** Removes the dead ends shorter than `minLength` that start at a border vertex, with that border
 *  vertex and what led to it inside of the room: rooms do not reach into their corners, and what is
 *  left there is no way out. Also a corridor of this length that leaves a room and comes back to
 *  it, unless it runs round an obstacle. O(n). */
[[nodiscard]] TopologyGraph removeShortDeadEnds(TopologyGraph graph, double minLength);

}  // namespace roomgraph
