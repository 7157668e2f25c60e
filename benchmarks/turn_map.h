#pragma once
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/Grid.h"

namespace roomgraph {

/** How a map is laid on another grid: turned about its centre, with other cells. */
struct MapPose {
  double angle = 0;  ///< counter-clockwise [rad]
  double finer = 1;  ///< how many times smaller the cells become
};

/** The map on a grid of that pose, just large enough for it, round the same centre. Each cell takes
 *  3 x 3 samples of the old cells: it is occupied where any of them is, so that walls of one cell
 *  stay closed, also where their cells meet in corners only; else it is what most of them are,
 *  unknown or free. Walls so grow by about a third of a cell on both sides, but not by quarter
 *  turns nor where cells become 2 times smaller; where they become 2 times larger, a cell is
 *  occupied if any of its four is. Beyond the map everything is as most of its border, so that a
 *  drawing without unknown cells stays one. */
GreyMap turnMap(const Grid& grid, const MapPose& pose);

/** Where a place of the turned map was in the old one. */
Point turnedBack(Point p, const MapPose& pose, const GridFrame& old);

}  // namespace roomgraph
