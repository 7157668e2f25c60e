#pragma once
#include <functional>
#include <vector>

#include "SiteEvidence.h"
#include "roomgraph/measures/MeasureKind.h"

namespace roomgraph {

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
