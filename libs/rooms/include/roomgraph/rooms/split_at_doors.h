#pragma once
#include "roomgraph/base/Options.h"
#include "roomgraph/rooms/trace_rooms.h"
#include "roomgraph/voronoi/keep_inside.h"

namespace roomgraph {

// Ours, in place of III-B's one alpha for the whole map
// In:   VoronoiGraph of the map without clutter, and what of it lies inside
// Out:  Regions: the rooms; what is in none is corridor
// Next: traceRooms

struct SplitAtDoorsOptions {
  /** A passage is a door where it is narrower than this share of the narrower of its two sides. */
  double maxRatio = 0.8;
  double maxWidth = 2.5;  ///< of a door [m]
  /** A region narrower than this share of the one that it opens into is a niche of that. */
  double nicheRatio = 0.6;
  double maxNicheDepth =
      1.5;  ///< of a niche, in widths of its opening; what is deeper is a corridor
  double minSideWidth = 1.0;      ///< of the largest disc on each side of a door [m]
  double minRoomWidth = 1.6;      ///< of the largest disc in a room [m]
  double maxElongation = 3.5;     ///< of a room; what is longer is a corridor
  double maxCorridorWidth = 5.0;  ///< a wider region is a room, however long [m]
};
void describe(SplitAtDoorsOptions& options, FieldTable& table);

/** Splits the inside at its doors. The alpha shapes of all alphas form a tree: going from wide to
 *  narrow, each widest place starts a region, and two regions meet where a disc of some diameter
 *  first fits through between them. They become one unless that passage is a door (narrow beside
 *  both) or one of them is narrow beside the other. So each room has its own door width and its own
 *  inscribed radius, and no alpha is set.
 *  What is narrow beside its neighbour and opens into that one only, a corner or an alcove, then
 *  joins it, unless it is long; what is left over is a corridor where it is too narrow for a room,
 *  or long and has two ways out. `minClearance` keeps passages between neighbouring cells of a wall
 *  out [m]. Equal widths are joined in no particular order, which does not show: only regions that
 *  are not equal are ever kept apart. O(n log n). */
Regions splitAtDoors(const VoronoiGraph& voronoi, const InsideFlags& isInside, double minClearance,
                     const SplitAtDoorsOptions& options);

}  // namespace roomgraph
