#pragma once
#include "roomgraph/scans/Recording.h"

namespace roomgraph {

// In:   a simplemap
// Out:  Recording
// Next: placeScans

/** Whether the file announces a CSimpleMap, under one of its names. */
bool isSimplemap(CheckedFile& file);

/** Takes a simplemap apart, of at most 1 GB when inflated. Every count is compared with the bytes
 *  that are left, and observations of other classes are stepped over. Where it has point clouds,
 *  `file` must outlive the recording. Throws DataError where anything contradicts the format or a
 *  number is absurd. O(file). */
Recording readSimplemap(CheckedFile& file);

}  // namespace roomgraph
