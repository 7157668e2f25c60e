#pragma once
#include <cstdint>

#include "roomgraph/base/Notes.h"
#include "roomgraph/grid/LoadGridOptions.h"
#include "roomgraph/scans/PlacedScan.h"
#include "roomgraph/scans/Recording.h"

namespace roomgraph {

// In:   Recording
// Out:  PlacedScans
// Next: gridOfScans, makeKeyframes, rawlogBytes

/** The horizontal scans of a recording, in its order. */
struct PlacedScans {
  std::string file;        ///< that they are from
  bool areSlices = false;  ///< of point clouds
  std::vector<PlacedScan> scans;
  Notes notes;  ///< what is not used, and what was chosen
};

/** The horizontal 2D scans of the recording, or, where it has none or options ask for a slice, the
 *  slices of its point clouds; where there are neither, 2D scans tilted by up to 3 degrees, as if
 *  they were level ("tilted_scans"). The points of each cloud are decoded once, and only if they
 *  are needed; again where those of all clouds take more than `mostKept` bytes. Throws DataError
 *  where there is none of these, or all clouds are kept in files that are missing. */
PlacedScans placeScans(Recording recording, const LoadGridOptions& options,
                       std::uint64_t mostKept = 1'000'000'000);

}  // namespace roomgraph
