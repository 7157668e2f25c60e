#pragma once
#include <string>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

/** What speaks against a run, one line. */
std::string reasonOf(const ComparedRun& run, const Comparison& comparison);

/** One line on all runs, ranked. */
std::string verdictOf(const Comparison& comparison);

}  // namespace roomgraph
