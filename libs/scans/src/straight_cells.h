#pragma once
#include <vector>

#include "roomgraph/grid/GridFrame.h"

namespace roomgraph {

/** How many of the cells lie in straight, thin pieces of at least ten, as those of walls do, along
 *  any of 36 directions. Cells may be repeated, and stand in any order. O(cells log cells). */
std::size_t countStraightCells(std::vector<Cell> cells);

}  // namespace roomgraph
