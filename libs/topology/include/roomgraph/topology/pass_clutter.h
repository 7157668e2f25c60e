#pragma once
#include <functional>

#include "roomgraph/topology/TopologyGraph.h"
#include "roomgraph/topology/dead_ends.h"

namespace roomgraph {

// Ours: clutter parts no paths, as it parts no rooms
// In:   TopologyGraph without dead ends, and where clutter and walls are
// Out:  the same with one way past each piece of clutter
// Next: joinVertices

using PlaceTest = std::function<bool(Point)>;  ///< whether something is true of a place [m]

/** Removes the narrowest of the ways round each piece of clutter, and the dead ends that are left;
 *  then again, with the pieces that no way parts any more as one, until each is passed on one side,
 *  the wider one. So no ladder of short paths grows among chairs. Of two ways as narrow as each
 *  other the shorter one goes, as that between two chairs of a row. Where these are equal, too,
 *  both go if what is connected stays so, and both stay if not: only the map's pose could decide
 *  between them.
 *
 *  Ways round anything that is not `isClutter`, asked for places of obstacles, stay. A loop that
 *  begins and ends at one junction goes. But one half stays of a way through a region that neither
 *  of its ends lies in. Nothing is parted. O(rounds * n log n). */
[[nodiscard]] TopologyGraph passClutter(TopologyGraph graph, const PlaceTest& isClutter,
                                        const ObstacleRows& walls, const DeadEndsOptions& options,
                                        const LeadsOn& leadsOn);

}  // namespace roomgraph
