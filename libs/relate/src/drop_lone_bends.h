#pragma once
#include "roomgraph/base/ForEach.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// Ours
// In:   how each two runs of a site lie in each other
// Out:  the same, without what buildings that repeat themselves feign
// Next: pairsInSite

/** Follows pairs anew, from their `poses` alone, of which one way tells a bend that the way back
 *  does not, and that the others tell of neither run: where a building repeats itself, pieces of a
 *  map fit where they do not belong. Pairs of two runs with scans stay, since scans tell better, as
 *  does each pair that nobody can be asked about. O(pairs * runs), and what following costs for
 *  each pair that is dropped. */
void dropLoneBends(MapPairs& pairs, const std::vector<Transform2D>& poses, const Site& site,
                   const ForEach& forEach);

}  // namespace roomgraph
