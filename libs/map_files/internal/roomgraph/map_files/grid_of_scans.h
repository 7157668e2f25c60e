#pragma once
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/LoadGridOptions.h"
#include "roomgraph/scans/place_scans.h"

namespace roomgraph {

// In:   PlacedScans
// Out:  GreyMap
// Next: binarize

/** The grid that MRPT builds of the scans, just large enough for them. Fills everything but the
 *  source's file, kind and hash. Throws DataError where they reach too far for a grid.
 *  O(scans + cells). */
GreyMap gridOfScans(const PlacedScans& scans, const LoadGridOptions& options);

}  // namespace roomgraph
