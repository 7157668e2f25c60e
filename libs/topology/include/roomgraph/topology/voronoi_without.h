#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/grid/obstacle_cells.h"
#include "roomgraph/topology/VoronoiGraph.h"

namespace roomgraph {

// Ours: the diagram without clutter, at the price of the clutter alone
// In:   VoronoiGraph, and which of its obstacles to leave out
// Out:  VoronoiGraph
// Next: keepInside, splitAtDoors

/** The Voronoi diagram of the obstacles that are not flagged. Only the holes that the others leave
 *  in the Delaunay triangulation are filled anew, each from the obstacles round it: a face that is
 *  empty of all obstacles is empty of these, too. `graph` must be voronoiGraph(obstacles). The
 *  obstacles keep their numbers; the flagged ones stay in `obstacles` and belong to no edge.
 *  O(n + h log h) for h obstacles round the holes. */
[[nodiscard]] VoronoiGraph voronoiWithout(const VoronoiGraph& graph, const ObstacleCells& obstacles,
                                          const std::vector<std::uint8_t>& isLeftOut);

}  // namespace roomgraph
