#pragma once
#include <cstdint>
#include <vector>

#include "RegionGroups.h"
#include "number_regions.h"

namespace roomgraph {

/** Per vertex that stands for a region, what that is; `widths` are its own ones. Needs areas and
 *  wall shares. */
std::vector<RegionKind> regionKinds(RegionGroups& regions, const std::vector<double>& widths);

/** Per vertex that stands for a region, its own width [m]: between walls that face each other about
 *  as far apart everywhere, where most of it lies between such; else that of its largest disc, and
 *  never more. So a corridor is as wide as it is nearly everywhere, whatever opens into it and
 *  however it bends. About as far apart is up to a square's side and its diagonal; of several such
 *  ranges the one with the largest area counts. `isWall`, per obstacle, tells walls from the edge
 *  of the unknown. O(n log n). */
std::vector<double> ownWidths(RegionGroups& regions, const std::vector<std::uint8_t>& isWall);

}  // namespace roomgraph
