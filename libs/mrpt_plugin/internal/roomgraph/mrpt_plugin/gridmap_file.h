#pragma once
#include <string>

#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/Grid.h"

namespace roomgraph {

// Ours
// In:   GreyMap, and the Grid that binarize made of it
// Out:  the bytes of an MRPT grid map
// Next: writeFileAtomically, loadGrid

/** The map as a COccupancyGridMap2D in the version that the installed MRPT writes, gzipped, with
 *  kGzipMark. Occupied and free cells keep their probabilities as far as MRPT's steps allow, all
 *  others become 0.5, so that loadGrid() gives the same Grid. Same map, same bytes. O(cells). */
std::string gridmapBytes(const GreyMap& map, const Grid& grid);

}  // namespace roomgraph
