#pragma once
#include <vector>

#include "MeasuredValue.h"
#include "graph_measures.h"
#include "room_measures.h"
#include "roomgraph/breaks/MapBreak.h"
#include "roomgraph/relate/DistinctMaps.h"
#include "roomgraph/relate/place_runs.h"
#include "run_measures.h"
#include "wall_sightings.h"

namespace roomgraph {

/** What the measures of a site are made from: what is known of it, and what several of them ask
 *  for. */
struct SiteEvidence {
  const Site& site;
  const MapPairs& pairs;
  const PairBends& bends;
  const DistinctMaps& maps;
  const Trust& trust;
  const std::vector<std::vector<MapBreak>>& breaks;  ///< of each run

  std::vector<MeasuredValue> coverage;  ///< of each run: what one covers hangs on all
  DistanceTable distances;
  SightingTable sightings;
  RoomCounts rooms;
  ComparedGraphs graphs;
};

}  // namespace roomgraph
