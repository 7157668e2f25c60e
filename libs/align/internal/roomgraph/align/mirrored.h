#pragma once
#include "roomgraph/align/WallMap.h"

namespace roomgraph {

// Ours
// In:   WallMap
// Out:  its mirror image
// Next: alignMaps

/** The mirror image of a map: what a scanner that was mounted upside down draws. Its x axis points
 *  the other way. Complete, if the map is. O(cells + walls * walls within 4 m). */
WallMap mirrored(const WallMap& map);

}  // namespace roomgraph
