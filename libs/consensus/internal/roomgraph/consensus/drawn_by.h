#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/relate/Run.h"

namespace roomgraph {

// Ours
// In:   Run
// Out:  DrawnBy
// Next: matchSubmaps

/** For each wall point of a map the submaps of its run that have drawn it. */
struct DrawnBy {
  std::vector<std::uint32_t> firsts;   ///< of each wall point in `submaps`, and the end of the last
  std::vector<std::uint32_t> submaps;  ///< ascending for each wall point
};

/** `map` is that of the run, and not bare. Numbers the submaps as runSubmaps does. O(scans * walls
 *  of a scan), or O(walls). */
DrawnBy drawnBy(const Run& run, const WallMap& map);

}  // namespace roomgraph
