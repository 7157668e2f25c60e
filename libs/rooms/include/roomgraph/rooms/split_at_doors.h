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

/** Splits the inside at its doors. The alpha shapes of all alphas form a tree: going from wide to
 *  narrow, each widest place starts a region, and two regions meet where a disc of some diameter
 *  first fits through between them. They become one unless that passage is a door (narrow beside
 *  both, or narrower than both in a wall that goes on at both of its ends; off what is as long as a
 *  corridor, however wide beside what it leads to), the front of a cubicle, or narrow beside the
 *  wider one. So each room has its own door width and its own inscribed radius, and no alpha is
 *  set. Then leftovers, such as door frames and the corners beside them, join the neighbour behind
 *  their widest passage; of several as wide the largest. So do alcoves, narrow regions that open
 *  widely into one other alone, and not through a door off a corridor, and bays: short regions that
 *  open with nearly their whole width into one wider room, and else at doors only. What remains is
 *  half seen, and neither room nor corridor, where it lies nearer to the edge of the unknown than
 *  to walls (`isWall`, per obstacle). It is a corridor where it is too narrow for a room, also
 *  beside the rest of the map; or narrow, and not closed by doors on all sides, nor by walls if it
 *  opens into anything but corridors; or no wider than a door may be, and open with nearly its
 *  whole width on two sides; or long (its area in squares round its largest disc is its elongation;
 *  or in squares of its own width, where most of it lies between walls that face each other about
 *  as far apart everywhere) with two ways out, to half-seen space is none, or far longer than a
 *  room without them; or where a corridor goes on through it: it leads on two sides to corridor
 *  that is about as wide by the mean over its whole length, or that opens into it, if it is longer
 *  than a niche, about as wide as it is; or where it is one of several such regions in a row, about
 *  as wide, without doors between pieces of a corridor, that are far longer together than a room.
 *  But it is a room, as one with a bath or round a table, if walls close it and doors that would
 *  part pieces of a corridor, and it is compact: it fills most of its convex hull, which is no
 *  longer than a room and wide enough for two of its ways side by side. Pieces of corridor without
 *  a door between them become one. One that is corridor by its aisles alone is a room: it goes
 *  round several islands in which no other region lies, none wider than its widest aisle, and would
 *  be no longer than a room without them, as a hall with shelves or desks. All widths are free
 *  ones, between the sides of obstacle cells of the map without clutter, `grid`, not between their
 *  centres. Fills in Regions::seen, too. `minClearance` keeps passages between neighbouring cells
 *  of a wall out [m]. Equal widths are judged together, so the order of the edges does not matter.
 *  O(n log n). */
[[nodiscard]] Regions splitAtDoors(const VoronoiGraph& voronoi, const InsideFlags& isInside,
                                   const std::vector<std::uint8_t>& isWall, double minClearance,
                                   const Grid& grid, const SplitAtDoorsOptions& options);

}  // namespace roomgraph
