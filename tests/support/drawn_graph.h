#pragma once
#include <functional>

#include "roomgraph/relate/follow_walls.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph::test {

/** A corridor of 20 m along y = 0 with junctions each 4 m or so and dead ends of uneven lengths off
 *  them; vertex 2 stands in the middle of a way and has two exits. No part looks like another. */
TopologyGraph drawnGraph();

/** The same with all places moved to where `place` says. */
TopologyGraph mapped(const TopologyGraph& graph, const std::function<Point(Point)>& place);

/** The same in another frame. */
TopologyGraph moved(const TopologyGraph& graph, const Transform2D& pose);

/** The same with all that lies beyond x carried by `far`. */
TopologyGraph bentAt(const TopologyGraph& graph, double x, const Transform2D& far);

/** What of it lies west of x. */
TopologyGraph westOf(const TopologyGraph& graph, double x);

/** The same without a vertex of two exits, whose ways become one. Its place is taken by the last.
 */
TopologyGraph withoutVertex(const TopologyGraph& graph, VertexId gone);

/** Patches each 2 m all over drawnGraph(), in the frame that `pose` carries it to. */
WallPatches patchesOver(const Transform2D& pose);

/** All of them followed to one pose. */
FollowedWalls everywhere(const WallPatches& patches, const Transform2D& pose);

}  // namespace roomgraph::test
