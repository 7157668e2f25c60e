#pragma once
#include <functional>

#include "MeasuredValue.h"
#include "compare_graphs.h"
#include "roomgraph/base/ForEach.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// In:   the runs of a site, placed, with their graphs
// Out:  MeasuredValue
// Next: measureSite

/** What the graphs of each two runs say of each other; a is the one with the lower index. */
using ComparedGraphs = PairTable<GraphComparison>;

/** `pairs` are those of the site. O(pairs * compareGraphs). */
ComparedGraphs comparedGraphs(const Site& site, const MapPairs& pairs,
                              const ForEach& forEach = oneByOne);

/** A figure of a comparison, and how several of them are taken together. */
struct GraphFigure {
  /** Of the first of the two graphs, or of the second. */
  std::function<MeasuredValue(const GraphComparison&, bool isFirst)> of;
  bool isSquared = false;  ///< means are taken of its square
};

/** Of one run against the others: the mean over them, weighted by trust times support. */
MeasuredValue graphMeasureOf(const GraphFigure& figure, const ComparedGraphs& graphs,
                             const Trust& trust, std::size_t run);

/** Of one pair, without an interval: both ways together. */
MeasuredValue graphMeasureOfPair(const GraphFigure& figure, const GraphComparison& graphs);

}  // namespace roomgraph
