#pragma once
#include <string>
#include <vector>

#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph::test {

/** What is wrong with the graph, one sentence each; empty where nothing is. Checks: ends in range;
 *  the path has two points or more, starts at the source and ends at the target; its length is the
 *  sum of its segments; its clearance is not below `clearance` (paths with obstacles only); no
 *  coordinate is infinite or NaN; dead ends have one way; paths do not properly cross each other
 *  (planarity; a path may touch or share a piece with another). O(segments log segments) on
 *  ordinary graphs. */
std::vector<std::string> brokenInvariants(const TopologyGraph& graph, double clearance);

}  // namespace roomgraph::test
