#pragma once
#include <vector>

#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

// Ours: the paper leaves one vertex of all paths in a room
// In:   TopologyGraph and which of its edges are in one room
// Out:  those that tell something, as a graph of their own
// Next: roomGraph, which puts them in

/** The ways through one room that tell more than spokes from its middle to its doors would: loops
 *  round shelves and islands, aisles, and dead ends that are places. Empty where there are none, as
 *  in a plain room.
 *
 *  Of the room's `edges` those go that are too narrow for a robot of `robotWidth` [m] and not
 *  needed to hold the others together; then the dead ends that are too narrow, or no deeper than an
 *  alcove: they reach less than 2.5 times their width, or than four times the robot's, beyond the
 *  disc at their base. All widths are free ones, between the sides of obstacle cells; `halfCell`
 *  [m] is what a clearance has more. Clutter must be passed on one side already (passClutter). The
 *  border vertices of `edges` come first, in their order. `edges` must be connected. O(n log n). */
[[nodiscard]] TopologyGraph innerWays(const TopologyGraph& graph, const std::vector<EdgeId>& edges,
                                      double robotWidth, double halfCell);

/** The same with a vertex of kind room at the place nearest to `center` on paths with at least
 *  `minClearance` [m], or with any where there is none; no border vertex. */
[[nodiscard]] TopologyGraph withRoomVertex(TopologyGraph ways, Point center, double minClearance);

/** The ways from such a vertex to the border vertices of a room without innerWays, along its
 *  `edges`, as a tree: where two part there is a junction, so that no route has to turn back in the
 *  middle. Loops are cut where they are narrowest. The border vertices come first, in their order.
 *  `edges` must be connected. O(n log n). */
[[nodiscard]] TopologyGraph innerTree(const TopologyGraph& graph, const std::vector<EdgeId>& edges,
                                      Point center, double minClearance);

}  // namespace roomgraph
