#pragma once
#include <functional>
#include <vector>

#include "RegionGroups.h"
#include "region_kinds.h"

namespace roomgraph {

/** A niche is a way where it is deeper than this [squares round its largest disc]. */
constexpr double kDeepestAlcove = 2.5;

/** Joins what is too small for an area of its own with a neighbour each. Needs areas. */
void joinLeftovers(RegionGroups& regions);

/** Calls `visit` with each region that is left over between two others of a kind, as the frame of a
 *  door is, and with these two. Needs areas. */
void eachDoorFrame(
    RegionGroups& regions, const std::vector<RegionKind>& kinds, RegionKind between,
    const std::function<void(std::uint32_t region, const RegionGroups::Neighbours& both)>& visit);

/** What is left over between two equal rooms is the frame of a door, and no area of its own. It
 *  joins one of them; the map's pose decides which. */
void joinDoorFrames(RegionGroups& regions, std::vector<RegionKind>& kinds);

}  // namespace roomgraph
