#pragma once
#include "roomgraph/base/Options.h"
#include "roomgraph/rooms/Regions.h"
#include "roomgraph/topology/keep_inside.h"

namespace roomgraph {

// Paper III-B
// In:   VoronoiGraph and what of it lies inside
// Out:  Regions
// Next: traceRegions

struct FindRoomsOptions {
  /** Diameter of the disc that must fit in everywhere; 0 to split at doors instead [m]. */
  double minWidth = 0;
  double alphaPx2 = 0;  ///< the same as CGAL's alpha, its squared radius [px2]; 0 for minWidth
};
void describe(FindRoomsOptions& options, FieldTable& table);

/** The disc's radius [m]. */
[[nodiscard]] double roomRadius(const FindRoomsOptions& options, double resolution);

/** Which places are in one room: those between which a disc of `radius` can move without touching
 *  an obstacle. Read off the Voronoi diagram: a room is a connected set of vertices with more
 *  clearance than `radius`, joined by edges with more clearance than that. traceRegions() gives
 *  each the union of its Delaunay faces, and so the inner polygons of the regularised alpha shape
 *  of CGAL. What is in no room is corridor, in pieces that are joined by edges of at least
 *  `minClearance` [m]. O(n). */
[[nodiscard]] Regions findRooms(const VoronoiGraph& voronoi, const InsideFlags& isInside,
                                double radius, double minClearance);

}  // namespace roomgraph
