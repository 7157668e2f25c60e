#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {

// In:   two maps, and what was followed of the one in the other
// Out:  TornEnd
// Next: followWalls

/** Walls that a map draws where the other one shows free space, and where they fit. */
struct TornEnd {
  std::vector<std::uint32_t> patches;  ///< that have some of these walls, ascending
  Transform2D pose;                    ///< other <- map
};

/** Looks together, within 3 m and at any turn, for the walls of `map` that are not found and lie
 *  where `other` shows free space: those of a stretch that was drawn in a wrong place fit as one,
 *  unlike furniture that has moved. None where they are few, or fit in several places. O(walls),
 *  and 0.1 s where there are enough. */
std::optional<TornEnd> findTornEnd(const WallMap& map, const WallMap& other,
                                   const FollowedWalls& followed, const std::vector<bool>& isFound);

}  // namespace roomgraph
