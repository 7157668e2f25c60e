#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/base/PairTable.h"
#include "roomgraph/relate/relate_maps.h"

namespace roomgraph {

/** MapPair of each two runs, or of those that were related; that of a and b is said of the one with
 *  the lower index first. Where it is asked for one that was not related, there is nothing that
 *  both have in common. */
struct MapPairs : PairTable<MapPair> {
  using PairTable<MapPair>::PairTable;

  /** The runs among which the consensus is worked out, ascending: of a site all are related to each
   *  other. Empty where all runs are. */
  std::vector<std::size_t> core;
};

}  // namespace roomgraph
