#pragma once
#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/mrpt_plugin/CRoomGraph.h"

namespace roomgraph {

/** The graph in 3D: one set of objects, named "room graph", which holds by name and from below to
 *  above "map" (where there is one), "rooms" (floors), "room outlines", "ways in rooms",
 *  "corridors", "vertices" and "room numbers" (of rooms that have a vertex, as the final graph's
 *  do). Parts without content are left out. Metres, map frame, z = 0 is the map. O(size of the
 *  graph and its map). `before`, what was drawn of another graph of the same map, lends its map,
 *  which takes most of the time of a large one. */
viz::CSetOfObjects::Ptr drawGraph(const MappedGraph& graph,
                                  const viz::CSetOfObjects::Ptr& before = nullptr);

/** The smallest upright box round all that is drawn; a square metre round the origin for nothing.
 */
Box drawnBox(const MappedGraph& graph);

/** A map with more cells than this on a side is drawn coarser. */
constexpr int kMostTexels = 2048;

/** Makes the camera look at all of the box [m] from above, slightly tilted, in even light. The box
 *  is one of the scene turned by `turn` [rad] about its origin, as the camera shows it. */
void lookFromAbove(MrptScene& scene, const Box& box, double turn = 0);

}  // namespace roomgraph
