#pragma once
#include "roomgraph/mrpt_plugin/CRoomGraph.h"

namespace roomgraph {

/** A hand-made floor of 24 x 16 m: a corridor with two rooms on each side, one of them round a
 *  pillar, a door between two rooms, and a vertex of each kind. With map, options and notes. */
CRoomGraph sampleGraph();

}  // namespace roomgraph
