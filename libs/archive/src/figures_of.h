#pragma once
#include <vector>

#include "roomgraph/archive/SiteHistory.h"
#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

/** All figures of a compared run, with those of its score, as an archive keeps them. */
std::vector<Measure> figuresOf(const ComparedRun& run, const Comparison& comparison);

/** What a compared run has of each room of the comparison. */
std::vector<RoomSeen> roomsOf(const ComparedRun& run, const Comparison& comparison);

}  // namespace roomgraph
