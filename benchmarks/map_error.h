#pragma once
#include <mrpt/maps/CSimpleMap.h>

#include <vector>

#include "walk.h"

namespace roomgraph {

// In:   a simplemap of range scans, and the true poses of its key frames
// Out:  how far its walls are from where they should be

/** Root mean square displacement of all places where beams met something, after the turn and shift
 *  of the whole map that fits best [m]. 0 without such a beam. Noise of ranges does not count. */
double mapError(const mrpt::maps::CSimpleMap& frames, const std::vector<WalkPose>& truth);

}  // namespace roomgraph
