#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/align/WallMap.h"
#include "roomgraph/base/ById.h"
#include "roomgraph/consensus/PoseGraph.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/relate/Run.h"
#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {

// In:   a run, and where its walls lie in a map
// Out:  FoundGroup
// Next: findConsensus

/** A group of matches that is to be added to a graph. */
struct FoundGroup {
  MatchGroup group;
  std::vector<PoseEdge> matches;  ///< ascending by `to`
};

/** For each wall point of a map the nodes of its run that have drawn it. */
struct DrawnBy {
  std::vector<std::uint32_t> firsts;  ///< of each wall point in `nodes`, and the end of the last
  std::vector<NodeId> nodes;          ///< ascending for each wall point
};

/** `map` is that of the run, and not bare; `nodes` are those that addRunNodes made of the run.
 *  O(scans * walls of a scan), or O(walls). */
DrawnBy drawnBy(const Run& run, IdRange<NodeId> nodes, const WallMap& map);

/** The map of a run, and which of its nodes drew what of it. */
struct DrawnMap {
  RunId run;
  const WallMap& map;  ///< not bare
  const DrawnBy& drawnBy;
};

/** Finds each node of `run`, which is `id` in the graph, in the map of another: scans by
 *  trackScans, patches as they were `followed`; `wholes` (map <- run) is where the runs may lie as
 *  a whole, the likeliest first. A match leads from the node of the other run that drew most of the
 *  walls it met. Nodes of which less than 45 % lies on walls there are not found. The groups are
 *  the stretches of a track between its jumps, or the layers in which patches were followed. Cost:
 *  that of trackScans. */
std::vector<FoundGroup> matchNodes(const PoseGraph& graph, RunId id, const Run& run,
                                   const DrawnMap& other, const FollowedWalls& followed,
                                   const std::vector<Transform2D>& wholes);

/** Finds each scan of `run` once more where `poses` have it: a few steps from there, in what the
 *  other run has drawn about its node next to it. Groups as above. O(scans * (nodes + walls of a
 *  scan)). */
std::vector<FoundGroup> matchAgain(const PoseGraph& graph, RunId id, const Run& run,
                                   const DrawnMap& other, const NodePoses& poses);

/** The scans that two runs have both, as runs over one log do. O((a + b) * log b). */
FoundGroup sameScans(const PoseGraph& graph, RunId a, const Run& runA, RunId b, const Run& runB);

}  // namespace roomgraph
