#pragma once
#include <vector>

#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/grid/GridFrame.h"

namespace roomgraph {

/** The cells of `frame` whose centre lies in the polygon, by row, then column.
 *  O(cells + corners log corners), where edges are no longer than a few rows. */
std::vector<Cell> cellsIn(const Polygon& polygon, const GridFrame& frame);

}  // namespace roomgraph
