#pragma once
#include "roomgraph/mrpt_plugin/CRoomGraph.h"

namespace roomgraph {

/** The graph in 3D: one set of objects, named "room graph", which holds by name and from below to
 *  above "map" (where there is one), "rooms" (floors), "room outlines", "ways in rooms",
 *  "corridors", "vertices" and "room numbers" (of rooms that have a vertex, as the final graph's
 *  do). Parts without content are left out. Metres, map frame, z = 0 is the map. A map with more
 *  than `kMostTexels` cells on a side is drawn coarser. O(size of the graph and its map). */
viz::CSetOfObjects::Ptr drawGraph(const CRoomGraph& graph);

constexpr int kMostTexels = 2048;

/** The smallest upright box round all that is drawn; a square metre round the origin for nothing.
 */
Box drawnBox(const CRoomGraph& graph);

}  // namespace roomgraph
