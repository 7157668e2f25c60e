#pragma once
#include <string>
#include <vector>

#include "roomgraph/relate/Run.h"

namespace roomgraph {

// In:   a run, and where its scans really lie
// Out:  a yaml
// Next: mola-sm-lc-cli of MOLA, version 1.1 or later

/** For its pipeline, where the path of a run really comes back to itself: of scans at most 1 m
 *  apart that have 10 m of path between them, the nearest pairs, each scan in one of them. Scans
 *  without a time of their own are left out. Ascending by the first. O(scans * scans nearby). */
std::string molaConstraints(const Run& run, const std::vector<Transform2D>& real);

/** Which scans have a time that no other key frame of the run has: by it they are found. */
std::vector<bool> haveOwnTimes(const std::vector<ScanWalls>& scans);

}  // namespace roomgraph
