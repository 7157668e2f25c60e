#pragma once
#include <vector>

#include "roomgraph/relate/Run.h"
#include "roomgraph/repair/RepairedRun.h"

namespace roomgraph {

// Parts of a repair that are the same with other runs and alone.

/** Stretches of scans that were not seen at another time, or by another run. */
std::vector<KeyFrames> unseenIn(const Run& run, const std::vector<bool>& isSeen);

/** Moves the scans of a run to `real` (site <- robot) by `repaired.frame`, and tells how far. */
void moveTo(const std::vector<Transform2D>& real, const Run& run, RepairedRun& repaired);

/** A covariance along axes that are turned by `angle` from those that it is along [rad]. */
PlanarCovariance turned(const PlanarCovariance& covariance, double angle);

}  // namespace roomgraph
