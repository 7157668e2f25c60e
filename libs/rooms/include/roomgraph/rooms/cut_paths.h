#pragma once
#include "roomgraph/rooms/border_vertices.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

// Paper III-D
// In:   TopologyGraph, PathStretches
// Out:  TopologyGraph whose edges each lie in one room or in none
// Next: roomIds

/** Cuts each path where one stretch ends and the next starts, and puts a border vertex there; it
 *  gets the room it borders, the smaller id where it borders two. Edges get the room of their
 *  stretch. The vertices of `graph` keep their ids; the paper's special cases, a crossing at the
 *  source or the target, need no cut and are left to roomIds. O(path points). */
[[nodiscard]] TopologyGraph cutPaths(TopologyGraph graph, const PathStretches& stretches);

}  // namespace roomgraph
