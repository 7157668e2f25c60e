#pragma once
#include <vector>

#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/images/png_bytes.h"

namespace roomgraph {

/** A colour for each room, such that rooms near to each other differ as long as there are colours
 *  left. Depends on the order of the rooms. O(n^2) in the number of rooms, but quick. */
std::vector<Colour> roomColours(const std::vector<const Polygon*>& rooms);

}  // namespace roomgraph
