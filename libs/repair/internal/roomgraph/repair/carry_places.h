#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/repair/CarriedPlace.h"
#include "roomgraph/repair/rejoin_pieces.h"

namespace roomgraph {

// Ours
// In:   places on one map, and the site that it and another map belong to
// Out:  CarriedPlace of each
// Next: carryThings

/** Carries places from run `from` of the site to run `to`: by the key frames of the one that have
 *  seen them from nearest by to where they really lie, and from there by those of the other, so
 *  each place moves as the maps bend around it. Then each is looked up on the map of `to`. Without
 *  scans, the walls that were followed carry them. O(places * key frames). */
std::vector<CarriedPlace> carryPlaces(const std::vector<Place>& places, const SolvedSite& solved,
                                      const RealPoses& real, std::size_t from, std::size_t to,
                                      const ForEach& forEach = oneByOne);

}  // namespace roomgraph
