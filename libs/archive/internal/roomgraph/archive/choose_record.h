#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "roomgraph/archive/SiteHistory.h"

namespace roomgraph {

// Ours
// In:   the runs of a site
// Out:  those of them that a new run is compared with
// Next: addRun

/** At most `most` indices into `runs` (which stand in the order of time), in their order: first up
 *  to a third that lie elsewhere and have come since the last run of the site, or are no fewer than
 *  its runs, as they may be the site, and it wrong; of the rest half are the latest, then those
 *  with the least map error, without breaks, then more of the latest; all of them among the last
 *  hundred. Other runs of another site are none of them, nor those that are not `isUsable`, which
 *  is asked of no more runs than needed. */
std::vector<std::size_t> chooseRecord(const std::vector<HistoryRun>& runs, std::size_t most,
                                      const std::function<bool(const HistoryRun&)>& isUsable);

}  // namespace roomgraph
