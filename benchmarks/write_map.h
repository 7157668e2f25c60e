#pragma once
#include <string>

#include "roomgraph/grid/GreyMap.h"

namespace roomgraph {

/** Writes the map as an MRPT COccupancyGridMap2D, gzipped without time stamp: the same map gives
 *  the same bytes. Throws DataError where the file cannot be written. */
void writeGridmap(const GreyMap& map, const std::string& file);

/** Writes `stem`.png and `stem`.yaml as ROS' map_saver does, in three levels. Throws DataError
 *  where a file cannot be written. */
void writeRosMap(const GreyMap& map, const std::string& stem);

}  // namespace roomgraph
