#pragma once
#include <vector>

#include "roomgraph/topology/shortest_ways.h"

namespace roomgraph {

/** Far from the origin, points of a path that follow each other may differ by rounding only [m]. */
constexpr double kSamePlace = 1e-6;

/** The point of the paths that is nearest to `p`, of those with at least `minClearance`, or half of
 *  the widest clearance where that is less. It is no border vertex: the room's own vertex is not
 *  one of those. Where there is no other, halfway on the longest path. There must be an edge.
 *  O(path points). */
[[nodiscard]] PlaceOnPath placeOnPaths(const TopologyGraph& graph, const std::vector<EdgeId>& edges,
                                       Point p, double minClearance);

/** The vertex at a place on a path: the path's end where it lies there, else a new one of `kind`
 *  that parts the edge; the part from its source keeps the number. */
VertexId splitAt(std::vector<Vertex>& vertices, std::vector<Edge>& edges, PlaceOnPath place,
                 VertexKind kind);

}  // namespace roomgraph
