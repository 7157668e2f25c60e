#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/align/WallMap.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {

// In:   two WallMap, and the walls of one followed in the other
// Out:  WallSighting of each wall
// Next: areStoreys, wallSightings

/** What another map has where a wall of this one is: `faded` where it shows free space up to the
 *  wall, and neither the wall nor free space in its place. */
enum class WallSighting : std::uint8_t { unknown, found, free, faded };

/** Of each wall point of a map, what the other has there. Each is looked for where the patch of
 *  walls next to it was followed to, so that bends are no missing walls; where nothing was
 *  followed, all is unknown. O(walls + patches^2). */
std::vector<WallSighting> sightWalls(const WallMap& map, const WallMap& other,
                                     const FollowedWalls& followed);

/** Of each wall point, whether its wall goes on straight for 2 m, to one side, to the other, or to
 *  both: furniture, which moves, seldom does. O(walls). */
std::vector<bool> straightWalls(const WallMap& map);

}  // namespace roomgraph
