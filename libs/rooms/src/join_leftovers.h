#pragma once
#include <vector>

#include "RegionGroups.h"
#include "region_kinds.h"
#include "roomgraph/rooms/SplitAtDoorsOptions.h"

namespace roomgraph {

/** A niche is a way where it is deeper than this [squares round its largest disc]. */
constexpr double kDeepestAlcove = 2.5;

/** Joins what is too small for an area of its own with a neighbour each; between two equal ones the
 *  map's pose decides. Needs areas. */
void joinLeftovers(RegionGroups& regions, const SplitAtDoorsOptions& options);

}  // namespace roomgraph
