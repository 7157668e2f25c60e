#pragma once
#include <mrpt/maps/CSimpleMap.h>

#include <string>

#include "roomgraph/grid/GreyMap.h"

namespace roomgraph {

/** Writes the map as an MRPT COccupancyGridMap2D, gzipped without time stamp: the same map gives
 *  the same bytes. Throws DataError where the file cannot be written. */
void writeGridmap(const GreyMap& map, const std::string& file);

/** The same of a simplemap; `compression` is that of gzip, from 1, fast, to 9, small. */
void writeSimplemap(const mrpt::maps::CSimpleMap& frames, const std::string& file,
                    int compression = 1);

/** Writes `stem`.png and `stem`.yaml as ROS' map_saver does, in three levels. Throws DataError
 *  where a file cannot be written. */
void writeRosMap(const GreyMap& map, const std::string& stem);

}  // namespace roomgraph
