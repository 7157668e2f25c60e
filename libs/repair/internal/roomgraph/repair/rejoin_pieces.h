#pragma once
#include <vector>

#include "roomgraph/consensus/site_consensus.h"

namespace roomgraph {

/** Where the scans of each run of a site really lie, in their order: site <- robot. */
using RealPoses = std::vector<std::vector<Transform2D>>;

// Ours: look-alike places tear what is whole
// In:   SolvedSite
// Out:  RealPoses, without the tears that nothing confirms
// Next: repairRuns, mergeRuns, carryPlaces

/** Where the consensus tears a run, the smaller part is put back to the larger one by its own links
 *  if the scans beside the tear fit there about as well on what other runs have seen, or if its own
 *  scans refute the tear: in a building that repeats itself, a part can be found in the wrong
 *  place, and a run that says that it drove on is the better witness. Of a run that is really torn
 *  they fit nothing there. Empty for runs without scans. O(scans). */
RealPoses rejoinPieces(const SolvedSite& solved);
/** The same of one run of the site, whose scans are said to lie at `poses`. */
std::vector<Transform2D> rejoinPieces(const SolvedSite& solved,
                                      const std::vector<Transform2D>& poses, std::size_t run);

}  // namespace roomgraph
