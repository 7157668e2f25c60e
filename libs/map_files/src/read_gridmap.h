#pragma once
#include "roomgraph/base/checked_file.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/LoadGridOptions.h"

namespace roomgraph {

/** What a cell of log-odds `cell` looks like: 255 * (1 - p(occupied)), rounded. */
std::uint8_t greyOfLogOdds(int cell);

/** Whether the file announces a COccupancyGridMap2D. */
bool isGridmap(CheckedFile& file);

/** Reads a file whose head announces a COccupancyGridMap2D. The cells come straight out of the
 *  checked bytes: MRPT's reader believes sizes that contradict the bounds, and needs a second copy
 *  of all the cells. Fills everything but the source's file and hash. */
GreyMap readGridmap(CheckedFile& file, const LoadGridOptions& options);

/** Reads a COccupancyGridMap2D object, from its header to its end, as readGridmap() does. */
GreyMap readGridmapObject(ByteReader& in);

}  // namespace roomgraph
