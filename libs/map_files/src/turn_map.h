#pragma once
#include "roomgraph/grid/GreyMap.h"

namespace roomgraph {

/** The map turned by `yaw` [rad, counter-clockwise] about the origin of its frame, in a frame that
 *  is along the axes again: cells keep their size, and those that the turned map does not cover are
 *  `outside`. Quarter turns move whole cells; what a turn misses of one by less than a quarter of a
 *  cell at the far corner counts as rounding. Any other turn gives each cell the nearest of the
 *  map, and none of the cells as dark as `darkest` is lost. Throws DataError, in the name of
 *  `file`, where the result has more than kMostCells. O(cells). */
GreyMap turned(const GreyMap& map, double yaw, std::uint8_t outside, std::uint8_t darkest,
               const std::string& file);

}  // namespace roomgraph
