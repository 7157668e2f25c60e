#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/align/scan_walls.h"
#include "roomgraph/consensus/PoseGraph.h"

namespace roomgraph {

// Ours
// In:   a pose graph, and where its nodes really lie
// Out:  which of them others bear out
// Next: confirmRuns

/** Of each node whether another run bears it out: it was found there, or something of that run was
 *  found on what it drew, by a match that agrees with the poses, of a group of which most do.
 *  O(nodes + edges). */
ById<NodeId, bool> confirmedNodes(const PoseGraph& graph, const NodePoses& poses,
                                  const ById<MatchGroupId, double>& belief);

/** Scans of a run that follow each other. */
struct ScanStretch {
  std::size_t first = 0, end = 0;  ///< places in the scans of the run; `end` is the first behind it

  [[nodiscard]] std::size_t size() const { return end - first; }
};

/** The stretches of a run none of whose scans is in `isFound`, in their order. O(scans). */
std::vector<ScanStretch> gapsOf(const std::vector<bool>& isFound);

/** Whether a stretch of scans is long: a dozen of them, or eight metres from the first to the last.
 *  Shorter ones lie between what holds them. O(scans of the stretch). */
bool isLong(const ScanStretch& stretch, const std::vector<ScanWalls>& scans);

}  // namespace roomgraph
