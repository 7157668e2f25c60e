#pragma once
#include "roomgraph/geometry/Point.h"
#include "roomgraph/grid/GridFrame.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// Ours
// In:   Site
// Out:  GridFrame
// Next: coverageOf, roomCounts

/** A frame round the walls of all placed runs, with the coarsest of their cells, 0.1 m or more;
 *  a single cell where there are no walls. O(walls). */
GridFrame siteFrame(const Site& site);

/** Whether a run has seen free space at `p` [m, frame of the map]. */
bool isFreeIn(const WallMap& map, Point p);

}  // namespace roomgraph
