#pragma once
#include "roomgraph/align/WallMap.h"
#include "roomgraph/grid/Grid.h"

namespace roomgraph {

// In:   Grid
// Out:  WallMap
// Next: alignMaps

/** Side of a cell of WallMap::frame; a coarser map keeps its own. Walls are known to about as much:
 *  one this far from where a scan has it counts half [m]. */
constexpr double kWallCell = 0.1;

/** Finds the walls of a map. A map without any free cell beside an occupied one has no walls, and
 *  aligns with nothing. O(cells + walls * walls within 4 m). */
WallMap wallMap(const Grid& grid);

/** The same without what it takes to look walls up in it (`nearest`, `depths`), and what it tells
 *  of itself (`axisDeviation`, `wallSharpness`, `wallDoubling`): enough to be looked for in another
 *  map. */
WallMap bareWallMap(const Grid& grid);

/** The known part of the map on cells of side `cell`, with a margin: occupied where any of its
 *  cells is, free where more are free than unknown. O(cells). */
Grid coarser(const Grid& grid, double cell, double margin);

/** Makes what alignMaps looks at of a map besides its walls: `turns`, of the walls given, and
 *  `freeCells` and `freeArea` of its states. O(cells + walls). */
void addSearchData(WallMap& map, const std::vector<WallPoint>& walls);

/** Makes `nearest` and `depths`, which only depend on the rest. O(cells). */
void addLookUp(WallMap& map);

/** Makes a map bare: it takes half the memory then. */
void dropLookUp(WallMap& map);

}  // namespace roomgraph
