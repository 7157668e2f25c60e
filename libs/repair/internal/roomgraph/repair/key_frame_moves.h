#pragma once
#include <string>
#include <vector>

#include "roomgraph/base/checked_file.h"
#include "roomgraph/relate/Run.h"
#include "roomgraph/repair/RepairedRun.h"
#include "roomgraph/scans/rewrite_simplemap.h"

namespace roomgraph {

// In:   RepairedRun, and the simplemap that it is of
// Out:  PoseMove of each key frame
// Next: movePoses, trajectoryTum; movedRun (repair_site.h) does both

/** How each key frame of the run's file is moved. One without a scan goes along with those before
 *  and behind it, with the nearer one more. O(key frames). */
std::vector<PoseMove> keyFrameMoves(const Run& run, const RepairedRun& repaired,
                                    const Recording& recording);

/** "time x y z qx qy qz qw", a line for each key frame, in their order [s, m]. A key frame without
 *  a time has one between those of its neighbours that have; where none has, times are the numbers
 *  of the key frames. O(key frames). */
std::string trajectoryTum(const Recording& recording, const std::vector<PoseMove>& moves);

/** The content of a simplemap as its file holds it; gzip has a comment on who has written it. */
std::string packedMap(const std::string& content, Compression how);

}  // namespace roomgraph
