#pragma once
#include "roomgraph/relate/relate_maps.h"

namespace roomgraph {

// Ours
// In:   two WallMap that surely lie in each other, followed
// Out:  whether they are two storeys of one building
// Next: relateMaps

/** Whether two maps agree in their outer walls and not in their inner ones: they surely lie in each
 *  other, and hardly bend, and yet of the straight walls of either map many stand where the other
 *  has seen free space. Furniture is seldom straight; walls that were built or torn down are there
 *  in one map only; and maps that bend or break are not asked. O(walls). */
bool areStoreys(const MapPair& pair, const WallMap& a, const WallMap& b);

}  // namespace roomgraph
