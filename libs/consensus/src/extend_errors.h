#pragma once
#include <vector>

#include "roomgraph/align/scan_walls.h"
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// In:   Consensus, and the scans of each run
// Out:  how far each scan is off on its own, and how large each run has drawn the site, in its
//       MapError
// Next: scoreRuns

/** How far the scans of a run lie off each on its own, as a bad scan matcher leaves them: the root
 *  mean square displacement of what they have drawn [m]. */
struct ScanJitter {
  double drawn = 0;  ///< of the run as it is
  double left = 0;   ///< of that, what other poses have not taken out
};

/** Scans that follow each other tell by which motion one lies on the other, and so does the next
 *  step. A scan that is off on its own is off against both, the other way round; where scans drift
 *  or break, a step tells nothing of the next. So it is what the corrections of two steps have in
 *  common, with the opposite sign. `poses` are those that the consensus has of the scans (site <-
 *  robot). 0 where fewer than ten scans lie on those before and behind them.
 *  O(scans * walls^2). */
ScanJitter scanJitter(const std::vector<ScanWalls>& scans, const std::vector<Transform2D>& poses);

/** Adds to each map error what the consensus has not taken out of its run: errors of single scans
 *  are small against what a link allows, and no match is sure to a few centimetres, so they are
 *  mostly left where they are. It counts as far as it is more than what the scans of sound runs
 *  show. Nothing changes for a reference, nor for runs without scans. Cost: that of scanJitter for
 *  each run. */
void addJitter(Consensus& consensus, const Site& site);

/** Tells of each run how long it has drawn what the consensus has 1 m long, by the scale of its
 *  links: odometry, or a lidar, that counts too much makes all of a map too large. Where the runs
 *  fall into two sets that differ by half a percent or more, and by three times what either set
 *  spans, the larger set is not right for being larger, as one robot may have driven all of it:
 *  unless one set is a single run of four or more, the interval of each run is extended so that
 *  either may be right, and its `scaleSet` says to which it belongs. Runs of which less than half
 *  is confirmed are in no set, nor is any run beside a reference. O(nodes + runs * log runs). */
void tellScales(Consensus& consensus);

}  // namespace roomgraph
