#pragma once
#include <vector>

#include "roomgraph/align/WallMap.h"

namespace roomgraph {

/** Makes what alignMaps looks at of a map besides its walls: `turns`, of the walls given, and
 *  `freeCells` and `freeArea` of its states. O(cells + walls). */
void addSearchData(WallMap& map, const std::vector<WallPoint>& walls);

}  // namespace roomgraph
