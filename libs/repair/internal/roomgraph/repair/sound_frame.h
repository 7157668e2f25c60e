#pragma once
#include <vector>

#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

// In:   poses as a run has them, and where they really lie
// Out:  the frame of the run
// Next: repairRuns

/** run <- site, such that most of `real` (site <- robot) stay where they `were` (run <- robot), and
 *  not the mean of all: of a torn run the larger part does not move. Least median of squares
 *  (Rousseeuw 1984), then least squares over what lies within 2.5 robust standard deviations.
 *  Deterministic. Changes nothing where there are no poses. O(poses). */
Transform2D soundFrame(const std::vector<Transform2D>& were, const std::vector<Transform2D>& real);

/** Root mean square distance of the places 5 m round two poses [m]: about as far as what a robot
 *  draws lies from it. */
double poseDistance(const Transform2D& l, const Transform2D& r);

}  // namespace roomgraph
