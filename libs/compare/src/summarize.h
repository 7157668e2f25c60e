#pragma once
#include <vector>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/compare/run_score.h"
#include "roomgraph/consensus/site_consensus.h"
#include "roomgraph/measures/measure_site.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

/** What was found out of a site; all lists are in the order of its runs. */
struct Findings {
  const Site& site;
  const MapPairs& pairs;
  const Consensus& consensus;
  const RunScores& scores;
  const std::vector<std::vector<MapBreak>>& breaks;
  const SiteMeasures& measures;
  const std::vector<SiteRoom>& rooms;
};

/** All of it in words and by name, the runs ranked; and what is known of the runs that are not of
 *  the site. `related` are all pairs of `runs`. */
Comparison summarize(const std::vector<Run>& runs, const MapPairs& related,
                     const Findings& findings);

}  // namespace roomgraph
