#pragma once
#include <vector>

#include "roomgraph/consensus/PoseGraph.h"

namespace roomgraph::test {

/** Poses of key frames, in their order. */
using Way = std::vector<Transform2D>;

/** Once round a block of 20 m by 10 m, a pose each metre from `offset` on, heading along it. */
Way roundTheBlock(double offset = 0);

/** The same way, which turns by `turn` too far with each step. */
Way drifting(const Way& way, double turn);

/** The same way with everything from pose `from` on turned about the robot and shifted. */
Way torn(const Way& way, std::size_t from, double turn, Point shift);

/** The same way, so many times as long. */
Way scaled(Way way, double scale);

/** The same way in another frame. */
Way moved(const Way& way, const Transform2D& motion);

/** What each of the nodes below has drawn [m, frame of the node]. */
const std::vector<Point>& drawnPoints();

/** A graph of runs whose key frames lie at `drawn`, each linked to the next. */
PoseGraph drawnPoseGraph(const std::vector<Way>& drawn);

/** With the matches of each pose of each way in the nearest one of each other way, exactly, where
 *  one is within 2 m; `truth` tells where the runs drawn lie. The groups are those of the first run
 *  in each other, of the second, and so on. */
PoseGraph matchedPoseGraph(const std::vector<Way>& drawn, const std::vector<Way>& truth);

/** The graph without its matches. */
PoseGraph withoutMatches(const PoseGraph& graph);

/** The graph with those of its matches that `keep`(group, edge, place in the group) says. */
template <class Keep>
PoseGraph withMatches(const PoseGraph& graph, const Keep& keep) {
  PoseGraph result = withoutMatches(graph);
  for (const MatchGroup& group : graph.groups) {
    std::vector<PoseEdge> kept;
    for (const PoseEdgeId id : group.edges)
      if (keep(group, graph.edges[id], group.edges.placeOf(id))) kept.push_back(graph.edges[id]);
    if (!kept.empty()) result.addGroup(group, kept);
  }
  return result;
}

/** Changes the matches by `change`(group, edge, place in the group). */
template <class Change>
void changeMatches(PoseGraph& graph, const Change& change) {
  for (const MatchGroup& group : graph.groups)
    for (const PoseEdgeId id : group.edges) change(group, graph.edges[id], group.edges.placeOf(id));
}

/** Whether a group joins these two runs. */
bool joins(const MatchGroup& group, std::size_t a, std::size_t b);

/** The poses of all runs, one after the other, and those of one. */
NodePoses posesOf(const std::vector<Way>& ways);
Way wayOf(const PoseGraph& graph, const NodePoses& poses, std::size_t run);

/** Root mean square distance of what nodes have drawn at two ways, after the best motion [m]. */
double displacement(const Way& way, const Way& truth);

/** Root mean square distance of poses, after the best motion of all of them together [m]. */
double misplaced(const Way& way, const Way& truth);
double misplaced(const NodePoses& poses, const std::vector<Way>& truth);

}  // namespace roomgraph::test
