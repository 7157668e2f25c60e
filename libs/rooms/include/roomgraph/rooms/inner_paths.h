#pragma once
#include <vector>

#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

/** The ways through one room, from a common start. */
struct InnerPaths {
  Point center;             ///< where they start: a place on a path inside of the room
  double clearance = 0;     ///< there [m]
  std::vector<Path> paths;  ///< to each of the asked vertices, in their order
};

/** Starts at the place nearest to `center` on the given edges with at least `minClearance`, or with
 *  any where there is none, and follows them on the shortest way to each of `ends`. That place is a
 *  point of a path, but no border vertex; where there is no other, halfway on the longest path.
 *  There must be at least one edge, and the edges must reach all ends. O(n log n). */
[[nodiscard]] InnerPaths innerPaths(const TopologyGraph& graph, const std::vector<EdgeId>& edges,
                                    const std::vector<VertexId>& ends, Point center,
                                    double minClearance);

}  // namespace roomgraph
