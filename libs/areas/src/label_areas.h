#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/areas/area_graph.h"

namespace roomgraph {

/** The labels of AreaGraph; `areaOf` tells the area of each region, none for a region that is in no
 *  area. */
std::vector<std::uint16_t> labelAreas(const ClearedSpace& space, const std::vector<AreaId>& areaOf);

}  // namespace roomgraph
