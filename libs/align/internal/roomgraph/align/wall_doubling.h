#pragma once
#include <optional>

#include "roomgraph/align/WallMap.h"

namespace roomgraph {

// Ours: what a map tells of itself, without any other
// In:   WallMap
// Out:  the share of its walls that are there twice
// Next: wallMap

/** The share of the wall points, 0 to 1, that have another wall 0.15 to 0.8 m straight in front of
 *  or behind them that faces the same way (within 20 degrees). The two sides of a wall face
 *  opposite ways, so they are no such pair: it takes a wall that was mapped in two places, or two
 *  things one of which hides the other, like a row of posts before a wall. None without walls.
 *  O(walls). */
std::optional<double> wallDoubling(const WallMap& map);

/** Whether a wall of the map is one of those. The map must not be bare. O(1). */
bool hasCopy(const WallMap& map, const WallPoint& wall);

}  // namespace roomgraph
