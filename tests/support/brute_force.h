#pragma once
#include <string>
#include <vector>

#include "roomgraph/pipeline/Stages.h"

namespace roomgraph::test {

/** The invariants of every step's graph, and what the steps promise about the map, each checked
 *  again in a slow and plain way: every place of every path is in a free cell and keeps the
 *  clearance from all cells that are not free; border vertices lie on the rings of the rooms that
 *  list them; connected stays connected. One sentence each; empty where all is well. */
std::vector<std::string> brokenPromises(const Stages& stages);

/** How many connected parts the graph has. */
std::size_t componentCount(const TopologyGraph& graph);

/** Two free places that a disc of the clearance radius can travel between must be connected in the
 *  kept Voronoi edges. Found by a flood fill over places `samplesPerCell` to a cell's side. Returns
 *  one sentence per broken pair. */
std::vector<std::string> lostConnections(const Stages& stages, int samplesPerCell);

}  // namespace roomgraph::test
