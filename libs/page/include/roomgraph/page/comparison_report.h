#pragma once
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

// In:   Comparison, and the maps of its runs
// Out:  report.html
// Next: a browser

/** One HTML file that needs no other file and no network: the verdict, the ranking with intervals,
 *  all maps laid on each other, where they disagree, the rooms, the places where maps bend, the
 *  pairs, what was left out and the options. Whatever the names contain is shown as text.
 *  It embeds comparison.json, from which its script draws.
 *  `runs` are looked up by name: a compared run whose map is not among them is not drawn. The
 *  picture of a run has at most 2500 pixels on a side, 1200 with more than 20 runs. The same input
 *  gives the same bytes. O(pixels of all pictures). */
[[nodiscard]] std::string comparisonReport(const Comparison& comparison,
                                           const std::vector<Run>& runs);

}  // namespace roomgraph
