#pragma once
#include <cstddef>
#include <optional>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/compare/Comparison.h"
#include "roomgraph/relate/KeptPairs.h"

namespace roomgraph {

struct CompareRunsOptions {
  bool areAligned = false;                ///< all maps are in one frame already
  std::optional<std::size_t> reference;   ///< the run to measure the others against
  double scoreScale = kScoreScale;        ///< map error at which the score is 100 / e [m]
  double leastShare = kLeastShare;        ///< of walls in common, for a score that is meaningful
  double breakShift = kBreakShift;        ///< from which on a jump of a run is a break [m]
  double breakRotation = kBreakRotation;  ///< the same for one that turns its map [rad]
  KeptPairs kept;              ///< where pairs are kept from call to call; changes nothing
  ForEach forEach = oneByOne;  ///< changes no number
  /** Up to so many runs are related each to each; of more, so many work out the consensus, and the
   *  others are held against it, see relateRuns. At least 3. */
  std::size_t core = 12;
};

}  // namespace roomgraph
