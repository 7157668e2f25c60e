#pragma once
#include <vector>

#include "RegionGroups.h"
#include "number_regions.h"

namespace roomgraph {

/** Joins pieces of corridor without a door between them, and makes corridor, in `kinds`, of the
 *  rooms that it goes on through: each leads on two sides to corridor, or to another one of these,
 *  and is no wider than that by the mean over its whole length; or, where it is longer than a
 *  niche, no wider by that mean than what opens into it. What is wide enough for a room, and has
 *  but narrow ways out, does not lead on through doors in walls that are not those of a corridor on
 *  both sides. All at once, so no order matters.
 *  Needs areas and wall shares. O(p log p) in the passages, for each time that more are found. */
void followCorridors(RegionGroups& regions, std::vector<RegionKind>& kinds, const Grid& grid);

}  // namespace roomgraph
