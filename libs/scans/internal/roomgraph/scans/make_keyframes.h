#pragma once
#include <vector>

#include "roomgraph/scans/Keyframe.h"
#include "roomgraph/scans/place_scans.h"

namespace roomgraph {

// In:   PlacedScans
// Out:  Keyframes
// Next: scanWalls

/** One for each scan. Beams without return or longer than `maxRange` [m] are left out. */
std::vector<Keyframe> makeKeyframes(const PlacedScans& scans, double maxRange);

}  // namespace roomgraph
