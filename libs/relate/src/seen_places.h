#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "roomgraph/align/WallMap.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** The squares of 1 m in which a run has seen free space, ascending: how much of a site it has, and
 *  what it shares with others in the same frame. */
using SeenPlaces = std::vector<std::int64_t>;

/** How many of some runs have seen a square. */
using SeenCounts = std::unordered_map<std::int64_t, std::size_t>;

/** `pose` carries the map into the common frame. Coordinates are cut at 10^9 m. O(free area). */
SeenPlaces seenPlaces(const WallMap& map, const Transform2D& pose);

}  // namespace roomgraph
