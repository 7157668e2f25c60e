#pragma once
#include "roomgraph/grid/ObstacleRows.h"
#include "roomgraph/rooms/Room.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

// Ours: the paper leads all ways of a room through one vertex
// In:   the ways of one room, with its border vertices first
// Out:  those of a hall with straight ways across its open floor
// Next: roomGraph, which puts them in

/** More ways across a hall, a room in which a disc of more than 6 m fits: straight ones between two
 *  of its vertices, or between the ways out of its border vertices, the shortest first, while the
 *  way along the others is more than 1.3 times as long and 3 m longer; then to what is farther than
 *  3 m from all of them, the farthest first, each from the nearest place of a way and ending in a
 *  dead end; then between these as before. Two border vertices always count, other vertices only
 *  where none lies between them. Each way keeps inside of the room, but where it ends, and at least
 *  `minClearance` from all obstacles [m], and has a junction wherever it crosses another one. What
 *  no such way leads to stays as it is, and so do other rooms. Vertices keep their numbers.
 *  O(v² + v m + n m) with v vertices, m ways and n squares of 1.5 m. */
[[nodiscard]] TopologyGraph hallWays(TopologyGraph ways, const Room& room,
                                     const ObstacleRows& obstacles, double minClearance);

}  // namespace roomgraph
