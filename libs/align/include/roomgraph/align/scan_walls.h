#pragma once
#include <vector>

#include "roomgraph/align/WallPoint.h"
#include "roomgraph/grid/load_keyframes.h"

namespace roomgraph {

// Ours
// In:   the scans of a run
// Out:  ScanWalls
// Next: trackScans, scanDisagreement

/** A scan as walls: what its neighbouring beams met. */
struct ScanWalls {
  Point at;                      ///< of the robot [m, frame of the run]
  std::vector<WallPoint> walls;  ///< [m, frame of the run]
};

/** At most `maxWalls` walls of each scan, evenly; beams that meet nothing near their neighbours'
 *  are left out. */
std::vector<ScanWalls> scanWalls(const std::vector<Keyframe>& frames, int maxWalls = 90);

}  // namespace roomgraph
