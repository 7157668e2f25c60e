#include "roomgraph/relate/are_storeys.h"

#include <algorithm>

#include "fitted_relate.h"
#include "roomgraph/align/alignment_confidence.h"
#include "roomgraph/relate/PairBend.h"
#include "roomgraph/relate/sight_walls.h"

namespace roomgraph {
namespace {

/** Of the straight walls of `of` that `in` knows, the share where it shows free space; 0 where
 *  there are too few. */
double contradictedShare(const WallMap& of, const WallMap& in, const FollowedWalls& followed) {
  const std::vector<WallSighting> seen = sightWalls(of, in, followed);
  const std::vector<bool> isStraight = straightWalls(of);
  double known = 0, free = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!isStraight[i] || seen[i] == WallSighting::unknown) continue;
    ++known, free += seen[i] == WallSighting::free ? 1 : 0;
  }
  return known >= kFewestWalls ? free / known : 0;
}

}  // namespace

bool areStoreys(const MapPair& pair, const WallMap& a, const WallMap& b) {
  if (pair.areEdits || pair.alignment.confidence < kSureConfidence) return false;
  if (std::max(pair.bInA.bend, pair.aInB.bend) > fitted::kHardlyBent) return false;
  return contradictedShare(b, a, pair.bInA) >= fitted::kOtherWalls &&
         contradictedShare(a, b, pair.aInB) >= fitted::kOtherWalls;
}

}  // namespace roomgraph
