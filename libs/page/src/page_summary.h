#pragma once
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

/** How many runs, pairs of them and rooms are compared: "4 runs of one site, 6 pairs, 5 rooms and
 *  corridors". */
std::string pageCounts(const Comparison& comparison);

/** What a page begins with: the verdict, behind a gate that fails. */
std::string pageVerdict(const Comparison& comparison);

/** What stands out, a plain sentence each: why the best run is best, which runs are torn, which
 *  rooms are missing where a run has looked, which pairs are doubtful, what was left out. Empty for
 *  a site without anything. */
std::vector<std::string> pageSummary(const Comparison& comparison);

/** Whether the best map is good enough to drive by, and what that rests on: a sentence or two, by
 *  the table of docs/scoring.md. Empty where there is no best map. */
std::string navigationWord(const Comparison& comparison);

/** The call of the program that repeats a comparison, as a shell takes it: its maps by the names of
 *  their files, by name, and all options that differ from the defaults. */
std::string commandLine(const Comparison& comparison);

/** What stands for the report where roomgraph was built without mustache, Leaflet and D3: one HTML
 *  file with the verdict, what stands out, and a sentence on what is missing. */
std::string bareReport(const Comparison& comparison);

}  // namespace roomgraph
