#pragma once
#include "roomgraph/consensus/PoseGraph.h"

namespace roomgraph {

/** How far the links of each run gave way in `poses`, at most 1: the root of their mean squared
 *  residual, but for the tenth that gives way most (Foerstner 1979, one step). Patches hold each
 *  other many times over, so of them it counts only how runs compare. Runs that share their drive
 *  err alike, so theirs is no less than 0.4, that of others no less than 0.1. O(edges). */
ById<RunId, double> runSlack(const PoseGraph& graph, const NodePoses& poses);

}  // namespace roomgraph
