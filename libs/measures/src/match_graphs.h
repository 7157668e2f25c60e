#pragma once
#include "roomgraph/relate/follow_walls.h"
#include "roomgraph/topology/TopologyGraph.h"
#include "shared_paths.h"

namespace roomgraph {

// Ours, after Schwertfeger and Birk (2015): similar vertices first, then from neighbour to
// neighbour
// In:   two TopologyGraphs, and how the walls of their maps lie in each other
// Out:  GraphMatch: which vertex is which, and which path
// Next: compareGraphs

/** A graph, the walls of its map, and where these lie in the other map. */
struct FollowedGraph {
  const TopologyGraph& graph;
  const WallPatches& patches;
  const FollowedWalls& followed;
};

/** Pairs each vertex of `a` with at most one of `b` and the other way round. A vertex is placed in
 *  the other map by the pose of the walls beside it, so that maps match that bend away from each
 *  other; where walls were mapped twice, by that copy which fits better. Rooms match rooms only.
 *  The surest pairs come first: near, and alike in kind, exits and clearance; from each the
 *  neighbours over edges of about the same length follow before others. Swapping the graphs swaps
 *  the answer, but for exact ties, which go by the vertex numbers. Empty where nothing was followed
 *  or a graph is empty. O(vertices * (vertices + patches within reach) + matches * edges
 *  around). */
GraphMatch matchGraphs(const FollowedGraph& a, const FollowedGraph& b);

}  // namespace roomgraph
