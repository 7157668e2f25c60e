#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/base/Options.h"
#include "roomgraph/grid/Grid.h"
#include "roomgraph/grid/obstacle_cells.h"

namespace roomgraph {

// Paper, end of IV-C: "one would first need to filter out smaller obstacles (e.g. using a 'pillar
// detection')"
// In:   Grid, ObstacleCells
// Out:  the same without clutter, and what of the rest is furniture, to find rooms in
// Next: voronoiWithout

struct ClearClutterOptions {
  double maxSize = 1.2;  ///< how far apart two places of an obstacle are; 0 keeps all [m]
};
void describe(ClearClutterOptions& options, FieldTable& table);

/** A small obstacle with free space all round it: a table, a pillar, a bin, a person, a speck. */
struct Clutter {
  Point center;     ///< of its box [m, map frame]
  double size = 0;  ///< how far apart two places of it are [m]
};

/** The map as if the clutter were not there. */
struct ClearedMap {
  Grid grid;                            ///< the map without clutter
  std::vector<std::uint8_t> isClutter;  ///< per obstacle; non-zero where it belongs to clutter
  std::vector<Clutter> clutter;  ///< by its first cell in the order of rows; without unseen specks
  std::vector<Cell> furniture;   ///< what is in the grid and splits no room either
};

/** Frees every connected group (8 neighbours) of cells that are not free, is not larger than the
 *  limit and does not touch the border; then, up to twice the limit, all that are compact and, in
 *  more than half of all directions, no farther from another obstacle that is left than that, or
 *  twice that where each is farther than the limit, as a table is in its room. So chairs are no
 *  room, and no order of the cells matters. What is small but stands between the ends of two walls
 *  that are in line with it, which are farther apart than the limit, is wall: the pier between two
 *  doors, a stub beside a hole, a post. Specks that beams have missed are cleared as well: groups
 *  with fewer occupied cells than half of the length of their rim. They are no obstacles, and so
 *  not in `clutter`. `obstacles` must be those of `grid`. O(cells).
 *
 *  Of what is left, furniture is what is solid, at most five times as long as the limit, between a
 *  quarter of it and twice it wide, with space for a robot all round, and not in line with a wall
 *  that goes on behind a gap no wider than a door: a shelf, a counter, a bench, a row of seats. So
 *  are leaves of doors that stand open: thin, at most as long as the limit, hung at a wall beside a
 *  doorway about as wide. */
[[nodiscard]] ClearedMap clearClutter(const Grid& grid, const ObstacleCells& obstacles,
                                      const ClearClutterOptions& options);

/** The same as if its furniture were clutter, to find rooms in; ways lead round it. O(cells). */
[[nodiscard]] ClearedMap withoutFurniture(ClearedMap cleared, const ObstacleCells& obstacles);

}  // namespace roomgraph
