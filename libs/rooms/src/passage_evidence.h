#pragma once
#include "roomgraph/grid/Grid.h"
#include "roomgraph/rooms/AreaGraph.h"
#include "roomgraph/rooms/SplitAtDoorsOptions.h"
#include "roomgraph/rooms/region_outlines.h"

namespace roomgraph {

// In:   a border of two areas, and the map without clutter
// Out:  PassageEvidence
// Next: areaGraph

/** What speaks for a passage between two areas of the map without clutter; `radius` is that of the
 *  largest disc in the narrower one [m]. Widths are free ones, as in splitAtDoors. O(width in
 *  cells). */
PassageEvidence passageEvidence(const Grid& grid, const RegionBorder& border, double radius,
                                const SplitAtDoorsOptions& options);

}  // namespace roomgraph
