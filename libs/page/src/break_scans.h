#pragma once
#include <vector>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

/** What the scans at a break met, for a small picture [m, site frame]; at most some hundred places
 *  each, evenly. Behind it as the run's map has them. Empty where the run is not among `runs`, or
 *  has no scans. */
struct BreakScans {
  std::vector<Point> before, behind;
};
BreakScans breakScans(const Comparison& comparison, const MapBreak& tear,
                      const std::vector<Run>& runs);

}  // namespace roomgraph
