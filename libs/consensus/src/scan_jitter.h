#pragma once
#include <vector>

#include "roomgraph/align/scan_walls.h"
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// Ours
// In:   the scans of a run, and where they lie
// Out:  how far each is off on its own
// Next: scoreRuns

/** How far the scans of a run lie off each on its own, as a bad scan matcher leaves them: the root
 *  mean square displacement of what they have drawn, against what those before and behind them have
 *  drawn [m]. `carries` is there <- run, of each scan. Where scans drift or break, each stays where
 *  the one before it was, so what lies between them grows with the steps from one to the other;
 *  errors of their own make the same difference however many these are. So it is the root of where
 *  the mean square distances of walls one, two and three steps apart, on a line, begin. 0 where too
 *  few scans see the same. O(scans * walls^2). */
double scanJitter(const std::vector<ScanWalls>& scans, const std::vector<Transform2D>& carries);

/** Adds to each map error what the consensus has not taken out of its run: errors of single scans
 *  are small against what a link allows, and no match is sure to a few centimetres, so they are
 *  left where they are. Of the run as it is drawn and as the consensus has it the smaller jitter
 *  counts, as far as it is more than what the scans of sound runs show; scans that were found in no
 *  other run say nothing. Nothing changes for a reference, nor for runs without scans. Cost: that
 *  of scanJitter for each run. */
void addJitter(Consensus& consensus, const Site& site);

}  // namespace roomgraph
