#pragma once
#include <cstddef>
#include <vector>

#include "seen_places.h"

namespace roomgraph {

// Ours
// In:   what a run has seen, and what each run of the core has
// Out:  those of the core that it is related to
// Next: relateMapsOver

/** Those of the core that have seen most of what a run has, as their places in `core`, in the order
 *  in which they were chosen: always the first `fixed`, then up to `count` in all. A place counts
 *  half as much with each chosen one that has seen it, so that together they have seen all of it,
 *  and most of it several times. Of equal ones the first. Fewer where no other shares a place with
 *  the run. O(core * count * places). */
std::vector<std::size_t> chooseJudges(const SeenPlaces& seen, const std::vector<SeenPlaces>& core,
                                      std::size_t count, std::size_t fixed);

}  // namespace roomgraph
