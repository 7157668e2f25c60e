#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/relate/Run.h"
#include "seen_places.h"

namespace roomgraph {

// Ours
// In:   the runs of a site, the best first, and what each has seen
// Out:  which of them work out where everything lies
// Next: chooseJudges

/** The runs of a site among which the consensus is worked out, as their places in `runs`, in the
 *  order in which they were chosen. Two thirds of `count` are the first runs, which should be those
 *  with the straightest walls; after them come those that add most places that fewer than two of
 *  the chosen, but two of all have seen, as long as each adds 2 % of such places: up to twice
 *  `count` in all; then the next first ones. The first `fixed` are always chosen. Copies of a map
 *  that is chosen are not, nor is a run without scans if a copy of it has some; and runs that share
 *  a drive with a chosen one come after all others. `seen` is in the order of `runs`.
 *  Deterministic. O(count * runs * (places + scans)). */
std::vector<std::size_t> chooseCore(const std::vector<const Run*>& runs,
                                    const std::vector<SeenPlaces>& seen, std::size_t count,
                                    std::size_t fixed);

}  // namespace roomgraph
