#pragma once
#include <cstddef>
#include <optional>

#include "roomgraph/consensus/PoseGraph.h"

namespace roomgraph {

// In:   a PoseGraph whose nodes know how their walls are turned
// Out:  WallAxes
// Next: solvePoseGraph

/** Along which axes the walls of each node lie. */
struct WallAxes {
  std::size_t count = 1;                            ///< pairs of axes; 0 is that of most nodes
  ById<NodeId, std::optional<std::size_t>> ofNode;  ///< none where that is not known
};

/** An angle between two pairs of axes, which quarter turns do not change, in (-pi/4, pi/4]
 *  [rad]. */
double axesAngle(double angle);

/** Most walls of a building are at right angles. Where a run has drawn walls that turn from one
 *  scan to the next, and stay so, it has come into a wing at another angle: such a stretch has axes
 *  of its own, until the walls lie along those of most again. Walls that turn slowly are a drift,
 *  whose axes are those of the building; so are those behind a step that the scans contradict.
 *  `start`: about where the nodes lie, site <- node. O(nodes). */
WallAxes wallAxes(const PoseGraph& graph, const NodePoses& start);

}  // namespace roomgraph
