#pragma once
#include <vector>

#include "roomgraph/compare/run_score.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// In:   a site with a reference
// Out:  ReferenceFaults
// Next: summarize

/** What speaks against a reference. */
struct ReferenceFaults {
  std::vector<MapBreak> breaks;  ///< in the frame of the site
  double doubled = 0;            ///< how far apart it has drawn one place twice, at most [m]
};

/** What a reference tells of itself (checkRun, of which no break is slight, and those left out of
 *  which nothing tells how large they are); nothing where there is none, or one without scans.
 *  Where there is anything, no score is meaningful: nobody is measured by what is broken. Cost:
 *  that of checkRun. */
ReferenceFaults askReference(const Site& site, RunScores& scores);

}  // namespace roomgraph
