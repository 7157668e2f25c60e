#pragma once
#include <vector>

#include "roomgraph/relate/Run.h"
#include "roomgraph/repair/RepairedRun.h"
#include "roomgraph/scans/move_poses.h"

namespace roomgraph {

// Ours
// In:   RepairedRun, and the poses of the key frames in its file
// Out:  PoseMove of each key frame
// Next: movePoses, trajectoryTum

/** How each key frame of the run's file is moved. One without a scan goes along with those before
 *  and behind it, with the nearer one more. O(key frames). */
std::vector<PoseMove> keyFrameMoves(const Run& run, const RepairedRun& repaired,
                                    const StoredPoses& stored);

}  // namespace roomgraph
