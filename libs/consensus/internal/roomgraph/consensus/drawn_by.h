#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/base/ById.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

// Ours
// In:   Run, its nodes
// Out:  DrawnBy
// Next: matchNodes

/** For each wall point of a map the nodes of its run that have drawn it. */
struct DrawnBy {
  std::vector<std::uint32_t> firsts;  ///< of each wall point in `nodes`, and the end of the last
  std::vector<NodeId> nodes;          ///< ascending for each wall point
};

/** `map` is that of the run, and not bare; `nodes` are those that addRunNodes made of the run.
 *  O(scans * walls of a scan), or O(walls). */
DrawnBy drawnBy(const Run& run, IdRange<NodeId> nodes, const WallMap& map);

}  // namespace roomgraph
