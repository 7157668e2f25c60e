#pragma once
#include <vector>

#include "RegionGroups.h"
#include "region_kinds.h"

namespace roomgraph {

/** A niche is a way where it is deeper than this [squares round its largest disc]. */
constexpr double kDeepestAlcove = 2.5;

/** Whether a region with these neighbours is too small for an area of its own. Needs areas. */
bool isLeftover(const RegionGroups& regions, std::uint32_t region,
                const RegionGroups::Neighbours& around);

/** Joins what is too small for an area of its own with a neighbour each. Needs areas. */
void joinLeftovers(RegionGroups& regions);

/** What is left over between two equal rooms is the frame of a door, and no area of its own. It
 *  joins one of them; the map's pose decides which. */
void joinDoorFrames(RegionGroups& regions, std::vector<RegionKind>& kinds);

}  // namespace roomgraph
