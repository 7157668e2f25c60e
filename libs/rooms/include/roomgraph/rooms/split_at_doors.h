#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/grid/Grid.h"
#include "roomgraph/rooms/Regions.h"
#include "roomgraph/rooms/SplitAtDoorsOptions.h"
#include "roomgraph/topology/keep_inside.h"

namespace roomgraph {

// Ours, in place of III-B's one alpha for the whole map
// In:   VoronoiGraph of the map without clutter, what of it lies inside, and its walls
// Out:  Regions: rooms, pieces of corridor, half-seen space
// Next: traceRegions

/** Splits the inside at its doors, so each room has a door width of its own and no alpha is set:
 *  - The alpha shapes of all alphas form a tree: from wide to narrow, each widest place starts a
 *    region, and two regions meet where a disc first fits through between them. They become one
 *    unless that passage is a door (narrow beside both, or an opening in a wall) or the front of a
 *    cubicle.
 *  - Leftovers, alcoves and bays join a neighbour.
 *  - A region with little wall round it is half seen, and neither room nor corridor. Any other is
 *    corridor by its width, its length and its ways out, or where a corridor goes on through it.
 *    Pieces of corridor without a door between them become one.
 *  - What only its aisles make long, as a hall with shelves, is a room.
 *
 *  The library's sources have the rules, each with a step or function of its own. All widths are
 *  free ones, between the sides of obstacle cells of the map without clutter, `grid`. `isWall`, per
 *  obstacle, tells walls from the edge of the unknown; `minClearance` keeps passages between
 *  neighbouring cells of a wall out [m]. Fills in Regions::seen, too. Equal widths are judged
 *  together, so the order of the edges does not matter. O(n log n). */
[[nodiscard]] Regions splitAtDoors(const VoronoiGraph& voronoi, const InsideFlags& isInside,
                                   const std::vector<std::uint8_t>& isWall, double minClearance,
                                   const Grid& grid, const SplitAtDoorsOptions& options);

}  // namespace roomgraph
