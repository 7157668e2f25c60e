#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/align/scan_walls.h"
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/consensus/PoseGraph.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// In:   Site, Consensus
// Out:  what of each run others bear out, in its MapError
// Next: scoreRuns

/** Tells of each run which of its nodes others bear out: those in a match with another run that
 *  agrees with the consensus, of a group that is believed, and what lies between two of these or
 *  at an end, if it is short. What is left nobody has found: it lies where its own links have it,
 *  and the upper end of the interval of its run rises by how far it may be off. Held by its links
 *  alone that is their drift; but what others know otherwise than it shows may lie anywhere that
 *  it reaches. Errors stay as they are. Nothing changes for a reference, nor for runs without
 *  scans. O(scans that nobody has * (nodes + walls of a scan)). */
void confirmRuns(Consensus& consensus, const Site& site, const MapPairs& pairs);

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
