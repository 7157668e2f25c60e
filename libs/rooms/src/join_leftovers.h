#pragma once
#include "RegionGroups.h"
#include "roomgraph/rooms/SplitAtDoorsOptions.h"

namespace roomgraph {

/** A niche is a way where it is deeper than this [squares round its largest disc]. */
constexpr double kDeepestAlcove = 2.5;

/** Joins what is too small for an area of its own with a neighbour each. Needs areas. */
void joinLeftovers(RegionGroups& regions, const SplitAtDoorsOptions& options);

}  // namespace roomgraph
