#pragma once
#include <vector>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

// In:   the walls of a map
// Out:  by how much what is shown of it is turned
// Next: pictures, scenes and windows

/** By how much a map that lies turned by `heading` [rad] is to be turned so that most of its walls
 *  stand upright, in (-pi/4, pi/4] [rad]. 0 where they do so within a degree, or have no direction
 *  in common. O(1). */
double uprightTurn(const WallMap& map, double heading);

/** The same for a site, about its origin: of the first of its runs whose map is among `runs`; 0
 *  where there is none. */
double uprightTurn(const Comparison& comparison, const std::vector<Run>& runs);

}  // namespace roomgraph
