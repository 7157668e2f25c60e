#pragma once
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

/** What stands out, a plain sentence each: why the best run is best, which runs bend, which rooms
 *  are missing where a run has looked, what was left out. Empty for a site without anything. */
std::vector<std::string> pageSummary(const Comparison& comparison);

}  // namespace roomgraph
