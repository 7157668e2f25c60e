#pragma once
#include <optional>

#include "roomgraph/grid/Grid.h"

namespace roomgraph {

// Ours: what a map tells of itself, without any other
// In:   Grid
// Out:  how clearly its free space ends at walls
// Next: wallMap

/** Cells that are drawn as wall, for each cell at the edge of free space. The first are occupied
 *  cells within 0.3 m of a free one, counted along rows and columns; the second free cells beside
 *  one that is not. Walls that bound all free space and are one cell thick give 1. Scans that do
 *  not fit wash walls out again and fray the edge, which lowers it; each further cell of thickness
 *  raises it. None where there is no wall beside free space. O(cells). */
std::optional<double> wallSharpness(const Grid& grid);

}  // namespace roomgraph
