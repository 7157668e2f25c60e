#pragma once
#include "roomgraph/base/Options.h"
#include "roomgraph/rooms/trace_rooms.h"
#include "roomgraph/voronoi/keep_inside.h"

namespace roomgraph {

// Ours, in place of III-B's one alpha for the whole map
// In:   VoronoiGraph of the map without clutter, and what of it lies inside
// Out:  Regions: rooms and corridors
// Next: traceRooms

struct SplitAtDoorsOptions {
  /** A passage is a door where it is narrower than this share of the narrower of its two sides. */
  double maxRatio = 0.8;
  double maxWidth = 2.5;       ///< of a door [m]
  double minRoomWidth = 1.0;   ///< of the largest disc in a region of its own [m]
  double maxElongation = 3.5;  ///< of a room; what is longer is a corridor, unless it is too wide
  double maxCorridorWidth = 5.0;  ///< a wider region is a room, however long [m]
};
void describe(SplitAtDoorsOptions& options, FieldTable& table);

/** Splits the inside at its doors. The alpha shapes of all alphas form a tree: going from wide to
 *  narrow, each widest place starts a region, and two regions meet where a disc of some diameter
 *  first fits through between them. That meeting is a door or joins the two: it is a door where it
 *  is narrow beside both, as told by the options. So each room has its own door width and its own
 *  inscribed radius, and no alpha is set. Noise of height h on the walls moves all these widths by
 *  at most 2 h (stability of persistence, Cohen-Steiner et al. 2007). `minClearance` keeps passages
 *  between neighbouring cells of a wall out [m]. O(n log n). */
Regions splitAtDoors(const VoronoiGraph& voronoi, const InsideFlags& isInside, double minClearance,
                     const SplitAtDoorsOptions& options);

/** Whether a region is long and narrow: the graph keeps its paths. O(polygon points). */
bool isCorridor(const Room& region, const SplitAtDoorsOptions& options);

/** Area over that of the square round the largest disc: 1 for a square, the ratio of its sides for
 *  a rectangle, large for a corridor however it bends. */
double elongation(const Room& room);

}  // namespace roomgraph
