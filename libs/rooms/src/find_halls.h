#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/rooms/Regions.h"
#include "roomgraph/rooms/SplitAtDoorsOptions.h"

namespace roomgraph {

// In:   VoronoiGraph and its Regions
// Out:  which pieces of corridor are halls
// Next: numberRegions

/** Whether each region is corridor by its aisles alone: it goes round islands that hold no other
 *  region and are no wider than its widest aisle, and with them it would be as short as a room.
 *  There are several islands, or doors close it as they would part two pieces of corridor.
 *  `halfCell` [m] is what a clearance has more than a free width. O(regions * islands + corners),
 *  as what is near one corner is near the next one, too. */
std::vector<std::uint8_t> findHalls(const VoronoiGraph& voronoi, const Regions& regions,
                                    double halfCell, const SplitAtDoorsOptions& options);

}  // namespace roomgraph
