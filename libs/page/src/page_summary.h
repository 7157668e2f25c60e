#pragma once
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

/** How many runs, pairs of them and rooms are compared: "4 runs of one site, 6 pairs, 5 rooms and
 *  corridors". */
std::string pageCounts(const Comparison& comparison);

/** What stands out, a plain sentence each: why the best run is best, which runs are torn, which
 *  rooms are missing where a run has looked, which pairs are doubtful, what was left out. Empty for
 *  a site without anything. */
std::vector<std::string> pageSummary(const Comparison& comparison);

/** Whether the best map is good enough to drive by, and what that rests on: a sentence or two, by
 *  the table of docs/scoring.md. Empty where there is no best map. */
std::string navigationWord(const Comparison& comparison);

}  // namespace roomgraph
