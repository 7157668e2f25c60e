#pragma once
#include <optional>
#include <vector>

#include "roomgraph/align/WallMap.h"
#include "roomgraph/align/WallPoint.h"
#include "roomgraph/grid/Grid.h"

namespace roomgraph {

// Ours: what a map tells of itself, without any other
// In:   Grid, WallMap
// Out:  how far its walls are from right angles, how clean they are, and which are there twice
// Next: siteConsensus

/** The share of the wall points, 0 to 1, that have another wall 0.15 to 0.8 m straight in front of
 *  or behind them that faces the same way (within 20 degrees). The two sides of a wall face
 *  opposite ways, so they are no such pair: it takes a wall that was mapped in two places, or two
 *  things one of which hides the other, like a row of posts before a wall. None without walls.
 *  O(walls). */
std::optional<double> wallDoubling(const WallMap& map);

/** Whether a wall of the map is one of those. The map must not be bare. O(1). */
bool hasCopy(const WallMap& map, const WallPoint& wall);

/** Which way the walls of a map go where they are straight, a direction for each such wall point,
 *  in (-pi/2, pi/2] [rad]: that of the points within 1.5 m that face the same way.
 *  O(walls * walls within 1.5 m). */
std::vector<double> wallDirections(const std::vector<WallPoint>& walls);

/** The direction of most walls, up to quarter turns [rad]: the mean of the largest set of them
 *  within 3 degrees. A building with a wing at another angle has one of the two, and not what lies
 *  between. None where no 15 % are alike. O(n log n). */
std::optional<double> mainDirection(std::vector<double> directions);

/** The median angle between the walls of a map and the nearer of its two main directions, which are
 *  at right angles [rad]. Every pose error turns some walls, so of several maps of one building the
 *  most rectangular one bends least; of different buildings it says nothing. None for fewer than
 *  100 directions. O(n). */
std::optional<double> axisDeviation(std::vector<double> directions);

/** Cells that are drawn as wall, for each cell at the edge of free space. The first are occupied
 *  cells within 0.3 m of a free one, counted along rows and columns; the second free cells beside
 *  one that is not. Walls that bound all free space and are one cell thick give 1. Scans that do
 *  not fit wash walls out again and fray the edge, which lowers it; each further cell of thickness
 *  raises it. None where there is no wall beside free space. O(cells). */
std::optional<double> wallSharpness(const Grid& grid);

}  // namespace roomgraph
