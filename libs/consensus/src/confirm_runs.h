#pragma once
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// Ours
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

}  // namespace roomgraph
