#pragma once
#include <optional>
#include <vector>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

// In:   the ends of a scan's beams
// Out:  ScanAxes
// Next: findConsensus

/** How the walls of a scan are turned, where they agree up to quarter turns. */
struct ScanAxes {
  double turn = 0;    ///< of the walls, modulo a quarter turn, in (-pi/4, pi/4] [rad, robot frame]
  double weight = 0;  ///< how much they tell: rises with their length and agreement, at most 1
};

/** The direction that most of a scan's straight walls have, up to quarter turns: the mean over
 *  straight pieces of about 1 m, by length. None where they are shorter than 2 m together, or do
 *  not agree, as in a building of slanted walls. `ends` in the order of the scan. O(ends). */
[[nodiscard]] std::optional<ScanAxes> scanAxes(const std::vector<Point>& ends);

}  // namespace roomgraph
