#pragma once
#include <vector>

#include "roomgraph/compare/run_score.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// Ours
// In:   a site with a reference
// Out:  MapBreak of the reference
// Next: summarize

/** The breaks that a reference tells of itself (checkRun, of which none is slight), in the frame of
 *  the site; none where there is no reference, of one without scans, and those of which nothing
 *  tells how large they are. Where there is one, no score is meaningful: nobody is measured by what
 *  is broken. Cost: that of checkRun. */
std::vector<MapBreak> askReference(const Site& site, RunScores& scores);

}  // namespace roomgraph
