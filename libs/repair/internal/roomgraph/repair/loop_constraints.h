#pragma once
#include <string>
#include <vector>

#include "roomgraph/relate/Run.h"

namespace roomgraph {

// Ours
// In:   a run, and where its scans really lie
// Out:  LoopConstraints
// Next: molaConstraints

/** Two key frames of a run that were at the same place. */
struct LoopConstraint {
  std::size_t from = 0, to = 0;     ///< their scans
  double fromTime = 0, toTime = 0;  ///< [s since 1970, UTC]
  double sigma = 0;                 ///< how far apart they may be [m]
};

/** Where the path of a run really comes back to itself: of scans at most 1 m apart that have 10 m
 *  of path between them, the nearest pairs, each scan in one of them. Scans without a time are left
 *  out. Ascending by the first. O(scans * scans nearby). */
std::vector<LoopConstraint> loopConstraints(const Run& run, const std::vector<Transform2D>& real);

/** The same for the pipeline of MOLA's mola-sm-lc-cli, version 1.1 or later. */
std::string molaConstraints(const std::vector<LoopConstraint>& constraints);

}  // namespace roomgraph
