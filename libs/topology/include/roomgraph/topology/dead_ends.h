#pragma once
#include <functional>

#include "roomgraph/base/Options.h"
#include "roomgraph/grid/ObstacleRows.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

// Paper III-A: "the dead ends ... are removed"
// In:   TopologyGraph
// Out:  TopologyGraph
// Next: joinVertices

struct DeadEndsOptions {
  /** How far a dead end must reach beyond the disc of its junction's clearance: a share of that
   *  clearance. The branch into a right-angled corner reaches 0.41. */
  double minReachRatio = 0.5;
  double minReach = 0.3;   ///< the same in metres; the larger one counts [m]
  bool allOnce = false;    ///< first remove every dead end once, whatever its length
  double minLengthPx = 0;  ///< then, once, all shorter than this [px]; 0 for the reach rule
};
void describe(DeadEndsOptions& options, FieldTable& table);

/** Whether a dead end from `base` to `tip` leads into a region that is worth a way. */
using LeadsOn = std::function<bool(const Vertex& tip, const Vertex& base)>;

/** Asked for a dead end: its tip, the vertex where it starts, and its path from either. */
using DeadEndTest = std::function<bool(const Vertex& tip, const Vertex& base, const Path& path)>;

/** Removes the dead ends for which `isShort`: all at once, then again, until none is left. A
 *  component never vanishes: its last edge stays. O(rounds * edges). */
[[nodiscard]] TopologyGraph removeDeadEndsWhere(TopologyGraph graph, const DeadEndTest& isShort);

/** Removes the dead ends that lead nowhere: all those under the limit at once, then again, until
 *  none is left; so the answer does not depend on their order. One that leads on is none of them,
 *  however large the hall is that it starts in, unless lengths in pixels are asked for. A component
 *  never vanishes: its last edge stays, and a vertex that loses its last edge stays as a junction
 *  without a way. O(rounds * edges). */
[[nodiscard]] TopologyGraph removeDeadEnds(TopologyGraph graph, const DeadEndsOptions& options,
                                           double resolution, const LeadsOn& leadsOn);

/** The same by the reach alone, where a junction's disc may also be that which touches only
 *  `walls`, the obstacles but the clutter: what ends between chairs lies in the hall that they
 *  stand in. O(rounds * edges) and, for each dead end, the cells of `walls` within its length. */
[[nodiscard]] TopologyGraph removeEndsAmongClutter(TopologyGraph graph,
                                                   const DeadEndsOptions& options,
                                                   const ObstacleRows& walls,
                                                   const LeadsOn& leadsOn);

}  // namespace roomgraph
