#pragma once
#include "RegionGroups.h"
#include "roomgraph/rooms/SplitAtDoorsOptions.h"

namespace roomgraph {

/** Joins what is too small for an area of its own with a neighbour each. Needs areas. */
void joinLeftovers(RegionGroups& regions, const SplitAtDoorsOptions& options);

}  // namespace roomgraph
