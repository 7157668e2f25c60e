#pragma once
#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/grid/ObstacleRows.h"
#include "roomgraph/topology/Path.h"

namespace roomgraph {

/** `clearance` is that of one of its ends, or more; the path has no more. */
Path straightPath(const ObstacleRows& obstacles, Point source, Point target, double clearance);

/** Whether a straight way from inside the polygon leaves it, other than within `tolerance` of where
 *  it ends. */
bool leavesPolygon(const Polygon& polygon, Point from, Point to, double tolerance);

}  // namespace roomgraph
