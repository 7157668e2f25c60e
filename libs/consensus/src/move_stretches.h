#pragma once
#include "roomgraph/consensus/PoseGraph.h"

namespace roomgraph {

/** Moves stretches of runs to where they cost less. A robust pose graph ends in the nearest
 *  minimum: a few key frames that were found in the wrong one of two rooms alike stay there,
 *  although both links that hold them have given way; and a run that is torn stays whole where what
 *  was found of it beyond the tear is given up. A stretch is what lies between links that gave way,
 *  what a group that is not believed was found of, all before or behind either, or a whole run; it
 *  is tried where the nodes beside it would have it, and where any of its matches would. Each group
 *  counts as far as it would be believed then. Short stretches first, again until none moves. The
 *  reference stays. The cost never rises. Deterministic. O(rounds * (links + places tried *
 *  matches)). */
void moveStretches(const PoseGraph& graph, const ById<RunId, double>& slack, NodePoses& poses);

}  // namespace roomgraph
