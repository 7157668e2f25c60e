#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "roomgraph/align/WallMap.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

// In:   what many runs have seen, the best of them first
// Out:  which of them work out where everything lies, and to which of these each other is related
// Next: relateMapsOver

/** The squares of 1 m in which a run has seen free space, ascending: how much of a site it has, and
 *  what it shares with others in the same frame. */
using SeenPlaces = std::vector<std::int64_t>;

/** `pose` carries the map into the common frame. Coordinates are cut at 10^9 m. O(free area). */
SeenPlaces seenPlaces(const WallMap& map, const Transform2D& pose);

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

/** Those of the core that have seen most of what a run has, as their places in `core`, in the order
 *  in which they were chosen: always the first `fixed`, then up to `count` in all. A place counts
 *  half as much with each chosen one that has seen it, so that together they have seen all of it,
 *  and most of it several times. Of equal ones the first. Fewer where no other shares a place with
 *  the run. O(core * count * places). */
std::vector<std::size_t> chooseJudges(const SeenPlaces& seen, const std::vector<SeenPlaces>& core,
                                      std::size_t count, std::size_t fixed);

/** All runs, those first whose maps others are best laid on: first those that have seen at least
 *  half as much as the largest, each group by how straight its walls are; equal ones in their
 *  order. */
std::vector<std::size_t> byStraightness(const std::vector<Run>& runs);

}  // namespace roomgraph
