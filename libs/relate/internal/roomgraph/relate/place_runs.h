#pragma once
#include <optional>
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/PairBend.h"
#include "roomgraph/relate/Site.h"
#include "roomgraph/relate/site_poses.h"

namespace roomgraph {

// In:   the runs, and how each two of them lie in each other
// Out:  Site, and what is known of its pairs
// Next: scoreRuns, siteBreaks, siteRooms

constexpr double kMinPairConfidence = 0.3;  ///< of runs that are joined

/** Whether two runs are taken for ones of one site. Of a symmetric building, no run is sure to lie
 *  in the right turn, but each lies in one of few. */
bool isJoined(const MapPair& pair);

/** Places the runs in one frame. The site is the largest set of runs that are joined by pairs of
 *  the same site (that of `reference`, if any; of equal ones the surest). Its frame is that of the
 *  run that the others fit best, or of the reference. Bare maps of the core are completed. Empty
 *  for no runs. O(runs * pairs). */
Site placeRuns(const std::vector<Run>& runs, const MapPairs& related,
               std::optional<std::size_t> reference);

/** What is known of those pairs of a site that were related. Pairs that have not found each other,
 *  or lie otherwise than in the site, are followed from the poses in the site, if they fit there.
 *  `related` are those of all runs; of its core, what is in the site is the core here. */
MapPairs pairsInSite(const Site& site, const MapPairs& related, const ForEach& forEach);

/** What of these is known of run `of` in another run. */
const FollowedWalls& followedIn(const MapPairs& pairs, std::size_t of, std::size_t in);

/** In how many others a run of these surely lies as it does there. O(others). */
std::size_t countSure(const MapPairs& pairs, std::size_t run);

/** The bends of these. The better map of two follows the worse one over a part of it only: so the
 *  larger bend of both ways counts. */
PairBends bendsOf(const MapPairs& pairs);

/** Follows pairs anew, from their `poses` alone, of which one way tells a bend that the way back
 *  does not, and that the others tell of neither run: where a building repeats itself, pieces of a
 *  map fit where they do not belong. Pairs of two runs with scans stay, since scans tell better, as
 *  does each pair that nobody can be asked about. O(pairs * runs), and what following costs for
 *  each pair that is dropped. */
void dropLoneBends(MapPairs& pairs, const std::vector<Transform2D>& poses, const Site& site,
                   const ForEach& forEach);

}  // namespace roomgraph
