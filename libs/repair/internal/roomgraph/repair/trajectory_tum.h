#pragma once
#include <string>
#include <vector>

#include "roomgraph/scans/move_poses.h"

namespace roomgraph {

// Ours
// In:   the poses of the key frames of a file, and how they are moved
// Out:  the text of a trajectory as the TUM benchmark has it, which evo reads
// Next: StagedFiles

/** "time x y z qx qy qz qw", a line for each key frame, in their order [s, m]. A key frame without
 *  a time has one between those of its neighbours that have; where none has, times are the numbers
 *  of the key frames. O(key frames). */
std::string trajectoryTum(const StoredPoses& stored, const std::vector<PoseMove>& moves);

}  // namespace roomgraph
