#pragma once
#include "roomgraph/grid/ObstacleRows.h"
#include "roomgraph/rooms/RoomIndex.h"
#include "roomgraph/topology/Path.h"

namespace roomgraph {

/** `clearance` is that of one of its ends, or more; the path has no more. */
Path straightPath(const ObstacleRows& obstacles, Point source, Point target, double clearance);

/** Whether a straight way from inside the room leaves it through one of its openings, other than
 *  within `tolerance` of where it ends. The way keeps the clearance that the index is made with. */
bool leavesRoom(const RoomIndex& index, Point from, Point to, double tolerance);

}  // namespace roomgraph
