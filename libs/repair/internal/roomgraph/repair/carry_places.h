#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/align/LocalScan.h"
#include "roomgraph/align/WallMap.h"
#include "roomgraph/base/ForEach.h"
#include "roomgraph/repair/CarriedPlace.h"
#include "roomgraph/repair/rejoin_pieces.h"

namespace roomgraph {

// In:   places on one map, and the site that it and another map belong to
// Out:  CarriedPlace of each
// Next: carryThings

/** Carries places from run `from` of the site to run `to`: by the key frames of the one that have
 *  seen them from nearest by to where they really lie, and from there by those of the other, so
 *  each place moves as the maps bend around it. Then each is looked up on the map of `to`. Without
 *  scans, the walls that were followed carry them. None is carried where nearly all of them are
 *  ambiguous, as in a building that repeats itself. O(places * key frames). */
std::vector<CarriedPlace> carryPlaces(const std::vector<Place>& places, const SolvedSite& solved,
                                      const RealPoses& real, std::size_t from, std::size_t to,
                                      const ForEach& forEach = oneByOne);

/** What a robot would see at a place by a map: the walls up to `range` [m] from it that face it and
 *  that no other wall hides, in the frame of the place (`at`: map <- place). None where the map
 *  knows nothing. O(walls + walls in range * cells to them). */
LocalScan viewFrom(const WallMap& map, const Transform2D& at, double range);

}  // namespace roomgraph
