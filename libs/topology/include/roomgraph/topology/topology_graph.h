#pragma once
#include "roomgraph/topology/TopologyGraph.h"
#include "roomgraph/topology/VoronoiGraph.h"
#include "roomgraph/topology/keep_clear.h"

namespace roomgraph {

// Paper III-A, second half
// In:   VoronoiGraph and the edges that are kept
// Out:  TopologyGraph
// Next: removeDeadEnds

/** Runs of kept Voronoi edges become paths; the Voronoi vertices where other than two of them meet
 *  become vertices. A closed run without such a vertex gets a ring vertex at its widest place, so
 *  that a ring corridor is not lost. A Voronoi vertex that lost all its edges is no vertex. The
 *  room ids are none. O(n). */
[[nodiscard]] TopologyGraph topologyGraph(const VoronoiGraph& voronoi, const EdgeIndices& kept);

}  // namespace roomgraph
