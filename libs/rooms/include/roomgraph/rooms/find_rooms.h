#pragma once
#include "roomgraph/base/Options.h"
#include "roomgraph/rooms/Room.h"
#include "roomgraph/voronoi/VoronoiGraph.h"
#include "roomgraph/voronoi/keep_inside.h"

namespace roomgraph {

// Paper III-B
// In:   VoronoiGraph and what of it lies inside
// Out:  Rooms
// Next: borderVertices

struct FindRoomsOptions {
  /** Diameter of the disc that must fit in everywhere; 0 to split at doors instead [m]. */
  double minWidth = 0;
  double alphaPx2 = 0;  ///< the same as CGAL's alpha, its squared radius [px2]; 0 for minWidth
};
void describe(FindRoomsOptions& options, FieldTable& table);

/** The disc's radius [m]. */
double roomRadius(const FindRoomsOptions& options, double resolution);

/** The inner polygons of the alpha shape of the obstacles: where a disc of `radius` fits in without
 *  touching one, grown to the obstacles that stop it. Two places are in one room if the disc can
 *  move between them. Read off the Voronoi diagram: a room is a connected set of vertices with more
 *  clearance than `radius`, joined by edges with more clearance than that, and its polygon is the
 *  union of their Delaunay faces. The regularised alpha shape of CGAL has the same polygons.
 *  Rooms are ordered by their smallest Voronoi vertex. O(n). */
Rooms findRooms(const VoronoiGraph& voronoi, const InsideFlags& isInside, double radius);

}  // namespace roomgraph
