#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "roomgraph/relate/Run.h"

namespace roomgraph {

// Ours
// In:   Run
// Out:  RunSubmaps
// Next: drawnBy, matchSubmaps, findConsensus

/** A part of a run that is rigid in itself: a key frame with its scan or, of a run without
 *  scans, a patch of its walls. A node of the pose graph. */
struct Submap {
  Transform2D pose;              ///< run <- submap
  PointSums points;              ///< what it drew [m, frame of the submap]
  std::optional<ScanAxes> axes;  ///< of its walls [frame of the submap]
};

/** Two submaps of a run, and that they are to keep their pose to each other. */
struct SubmapLink {
  std::uint32_t from = 0, to = 0;
};

/** A run as the submaps that it is made of. */
struct RunSubmaps {
  std::vector<Submap> submaps;    ///< key frames in the order of the run, or patches
  std::vector<SubmapLink> links;  ///< each key frame to the next, or neighbouring patches
  bool areScans = false;
};

/** Cuts a run into submaps: its key frames where it has scans, else its wall patches. O(scans), or
 *  O(walls). */
RunSubmaps runSubmaps(const Run& run);

}  // namespace roomgraph
