#pragma once
#include <optional>

#include "roomgraph/grid/Grid.h"

namespace roomgraph {

// In:   Grid
// Out:  Grid without rims
// Next: wallMap

constexpr int kWidestRim = 2;  ///< of unknown cells between free space and a wall [cells]

/** Some mappers, cartographer among them, leave a rim of one or two unknown cells between free
 *  space and the cells of a wall. Where that is how the map's walls are drawn, as more free cells
 *  have a wall behind such a rim than right beside them, the rim becomes free, so that the wall has
 *  a face; none comes back for any other map. Rims are looked for along rows and columns.
 *  O(cells). */
[[nodiscard]] std::optional<Grid> clearWallRims(const Grid& grid);

}  // namespace roomgraph
