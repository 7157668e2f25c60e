#pragma once
#include <functional>
#include <vector>

#include "MeasuredValue.h"
#include "graph_measures.h"
#include "room_measures.h"
#include "roomgraph/breaks/MapBreak.h"
#include "roomgraph/measures/measure_kinds.h"
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
  const Trust& trust;                                ///< on where things are
  const Trust& witnesses;                            ///< on what there is to be seen
  const std::vector<std::vector<MapBreak>>& breaks;  ///< of each run

  std::vector<MeasuredValue> coverage;  ///< of each run: what one covers hangs on all
  SightingTable sightings;
  RoomCounts rooms;
  ComparedGraphs graphs;
};

// Ours, and after Schwertfeger and Birk (2015)
// In:   SiteEvidence
// Out:  MeasuredValue
// Next: measureSite

/** A measure: all that is said about it, and how it is computed. */
struct MeasureRow {
  MeasureKind kind;
  /** Of a run against the others, or by itself; none where only pairs have it. */
  std::function<MeasuredValue(const SiteEvidence&, std::size_t run)> ofRun;
  /** Of a pair of runs; none where only runs have it. */
  std::function<MeasuredValue(const SiteEvidence&, std::size_t a, std::size_t b)> ofPair;
};

/** All measures, in the order of all tables. Whatever asks for measures asks here. */
const std::vector<MeasureRow>& measureTable();

}  // namespace roomgraph
