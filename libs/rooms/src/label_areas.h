#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/rooms/AreaGraph.h"
#include "roomgraph/rooms/RoomGraph.h"
#include "roomgraph/rooms/region_outlines.h"

namespace roomgraph {

/** The labels of AreaGraph; `areaOf` tells the area of each region, none for a region that is in no
 *  area. */
std::vector<std::uint16_t> labelCells(const Grid& grid, const std::vector<RegionBorder>& borders,
                                      const std::vector<AreaId>& areaOf);

/** Whether two regions meet there in an opening that is wide enough for the robot. */
inline bool isPassage(const RegionBorder& border, double clearance) {
  return border.clearance > 0 && border.clearance >= clearance;
}

/** Per region, non-zero where the graph reaches it. */
std::vector<std::uint8_t> reachedRegions(const RegionOutlines& outlines, const RoomGraph& graph,
                                         double clearance);

}  // namespace roomgraph
