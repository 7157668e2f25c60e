#pragma once
#include <vector>

#include "RegionGroups.h"
#include "number_regions.h"
#include "roomgraph/rooms/SplitAtDoorsOptions.h"

namespace roomgraph {

/** Per vertex that stands for a region, what that is; `widths` are its own ones. Needs areas and
 *  wall shares. */
std::vector<RegionKind> regionKinds(RegionGroups& regions, const SplitAtDoorsOptions& options,
                                    const std::vector<double>& widths);

}  // namespace roomgraph
