#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include "roomgraph/grid/GreyMap.h"

namespace roomgraph {

/** The map as MRPT's class, cell by cell; the grey levels are kept as its log-odds allow. */
mrpt::maps::COccupancyGridMap2D makeMrptGrid(const GreyMap& map);

}  // namespace roomgraph
