#pragma once
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/ledger/SiteRoom.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// Ours: the ledger of a site
// In:   the runs of a site in one frame, with their areas, and their Consensus
// Out:  SiteRoom
// Next: nameRooms, comparisonJson

/** The rooms and corridors that the runs have, and what each run says of each. Each area lies in
 *  the site as the key frames that have drawn it do by the consensus `agreed`, not as its run does
 *  as a whole: behind a tear these are many metres apart. Areas of several runs are one room where
 *  they overlap after a small move of the room and their neighbours behind the doors match, too.
 *  Which areas are rooms at all is put to the vote of the runs, by trust; what one run alone has
 *  and the others contradict is none. Rooms get the ids R1, R2, ..., corridors C1, C2, ..., largest
 *  first. SiteRoom::runs are those of the site, in that order. Does not depend on the order of the
 *  jobs, nor on that of the placed runs but in exact ties. Empty where no run has an area.
 *  O(runs * rooms * (rooms + cells of a room)). */
std::vector<SiteRoom> siteRooms(const Site& site, const Consensus& agreed, const Trust& trust,
                                const ForEach& forEach = oneByOne);

/** Brings rooms into the order of their ids: R1, R2, R10, then C1. */
void sortRooms(std::vector<SiteRoom>& rooms);

}  // namespace roomgraph
