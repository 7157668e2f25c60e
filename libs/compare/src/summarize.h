#pragma once
#include <vector>

#include "roomgraph/check/find_refuted.h"
#include "roomgraph/compare/Comparison.h"
#include "roomgraph/compare/run_score.h"
#include "roomgraph/consensus/map_errors.h"
#include "roomgraph/measures/measure_site.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/Run.h"
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
  double referenceDoubled;  ///< see Comparison
  const std::vector<WeldedKeyFrames>& welded;
};

/** All of it in words and by name, the runs ranked; and what is known of the runs that are not of
 *  the site. `related` are all pairs of `runs`. */
Comparison summarize(const std::vector<Run>& runs, const MapPairs& related,
                     const Findings& findings);

/** The way of the robot in a run that lies at `pose` (site <- run), with the errors of its key
 *  frames. These are left out where no other run bears out where a key frame lies, and where
 *  `error` is that of a copy of the map without scans. */
std::vector<PathPose> runPath(const Run& run, const Transform2D& pose, const MapError& error);

}  // namespace roomgraph
