#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/rooms/AreaGraph.h"
#include "roomgraph/rooms/region_outlines.h"

namespace roomgraph {

/** The labels of AreaGraph; `areaOf` tells the area of each region, none for a region that is in no
 *  area. */
std::vector<std::uint16_t> labelCells(const Grid& grid, const std::vector<RegionBorder>& borders,
                                      const std::vector<AreaId>& areaOf);

}  // namespace roomgraph
