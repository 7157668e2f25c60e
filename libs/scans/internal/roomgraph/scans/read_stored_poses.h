#pragma once
#include "roomgraph/base/checked_file.h"
#include "roomgraph/scans/StoredPose.h"

namespace roomgraph {

// Ours
// In:   a simplemap
// Out:  StoredPoses
// Next: movePoses

/** The poses of all key frames of a simplemap, those without a scan, too, and the places of their
 *  bytes in its content. Checks as loadGrid does. O(file).
 *  @throws DataError where the file is damaged or no simplemap. */
StoredPoses readStoredPoses(CheckedFile& file);

}  // namespace roomgraph
