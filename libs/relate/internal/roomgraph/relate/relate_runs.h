#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/relate/KeptPairs.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

// In:   the runs
// Out:  MapPair of pairs of runs
// Next: placeRuns

struct RelateRunsOptions {
  bool areAligned = false;               ///< all maps are in one frame already
  std::optional<std::size_t> reference;  ///< a run that all others of its site are related to
  std::size_t core = 12;                 ///< up to so many runs each is related to each; at least 3
  bool areOneSite = false;               ///< all maps are said to show one site, see relateMaps
};

/** What relateMaps gives for each two runs: first those with the hub, the first byStraightness,
 *  then the others by relateMapsOver, which saves nearly all of the search. With `areAligned` by
 *  relateAlignedMaps.
 *
 *  Of more than `core` runs, those that lie in the hub have a core, see chooseCore, in which each
 *  is related to each; every other one is related to the hub and a choice of the core, see
 *  chooseJudges, and to its first copy. What does not lie in the hub is looked for in three more
 *  runs of the core. What is left then is related in the same way by itself, as another site. So
 *  the cost grows with the runs, as long as they are of few sites.
 *
 *  Pairs that are kept are not worked out again, so that one more run costs its own pairs only,
 *  unless it becomes the hub or one of the core. The same for any order of the jobs, and with or
 *  without kept pairs. */
MapPairs relateRuns(const std::vector<Run>& runs, const RelateRunsOptions& options,
                    const ForEach& forEach, const KeptPairs& kept = {});

}  // namespace roomgraph
