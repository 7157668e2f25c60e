#pragma once
#include "pose_graph.h"

namespace roomgraph {

/** Moves whole pieces of runs to where they cost less. A robust pose graph ends in the nearest
 *  minimum: a few key frames that were found in the wrong one of two rooms alike stay there,
 *  although both links that hold them have given way. A piece is what lies between links that gave
 *  way; it is tried where the submaps beside it would have it, and where any of its matches would.
 *  Small pieces first, again until none moves. The cost never rises. Deterministic. O(rounds *
 *  (links + places tried * matches)). */
void movePieces(const PoseGraph& graph, SubmapPoses& poses);

}  // namespace roomgraph
