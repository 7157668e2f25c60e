#pragma once
#include <string>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

/** Sets the reason of each run: what speaks against it, one line. */
void addReasons(Comparison& comparison);

/** One line on all runs, ranked. */
std::string verdictOf(const Comparison& comparison);

}  // namespace roomgraph
