#pragma once
#include <vector>

#include "compare_graphs.h"
#include "roomgraph/base/ForEach.h"
#include "roomgraph/measures/Measure.h"
#include "roomgraph/relate/Site.h"
#include "roomgraph/relate/relate_runs.h"

namespace roomgraph {

// Ours
// In:   the runs of a site, placed, with their graphs
// Out:  Measure
// Next: compareRuns

/** What the graphs of each two runs say of each other; a is the one with the lower index. */
using ComparedGraphs = PairTable<GraphComparison>;

/** `pairs` are those of the site. O(runs^2 * compareGraphs). */
ComparedGraphs comparedGraphs(const Site& site, const MapPairs& pairs,
                              const ForEach& forEach = oneByOne);

/** Of one run against the others: `path_coverage`, `global_accuracy`, `relative_accuracy`,
 *  `consistency_1`, `_2`, `_4`, `_8`, `path_length_error`, `path_frechet` and `nearest_vertex`, see
 *  GraphComparison. Each is the mean over the others, weighted by trust times support; root mean
 *  square for both accuracies. Meaningful with three runs and enough support (10 vertices, paths or
 *  pairs of vertices; 20 m of paths). */
std::vector<Measure> graphMeasuresOf(const ComparedGraphs& graphs, const Trust& trust,
                                     std::size_t run);

/** The same figures of one pair, in the same order and without an interval: coverage and nearest
 *  vertices of both ways together. Meaningful by support alone. */
std::vector<Measure> graphMeasuresOfPair(const GraphComparison& graphs);

}  // namespace roomgraph
