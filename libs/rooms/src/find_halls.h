#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/rooms/Regions.h"
#include "roomgraph/rooms/SplitAtDoorsOptions.h"

namespace roomgraph {

// In:   VoronoiGraph and its Regions
// Out:  which pieces of corridor are halls
// Next: numberRegions

/** Whether each region is corridor by its aisles alone: it goes round several islands that hold no
 *  other region and are no wider than its widest aisle, and with them it would be as short as a
 *  room. O(regions * islands + corners), as what is near one corner is near the next one, too. */
std::vector<std::uint8_t> findHalls(const VoronoiGraph& voronoi, const Regions& regions,
                                    const SplitAtDoorsOptions& options);

}  // namespace roomgraph
