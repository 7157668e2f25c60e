#pragma once
#include "roomgraph/page/site_pictures.h"

namespace roomgraph {

/** By how much a picture of the site is turned so that most walls of this map stand upright, in
 *  (-pi/4, pi/4] [rad]. 0 where they do so within a degree, or have no direction in common.
 *  O(walls). */
double uprightTurn(const PlacedMap& placed);

}  // namespace roomgraph
