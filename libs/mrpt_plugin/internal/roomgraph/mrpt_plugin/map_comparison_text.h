#pragma once
#include <string>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

/** The verdict, the ranking, and where runs break, as a page of plain text. */
std::string mapComparisonText(const Comparison& comparison);

}  // namespace roomgraph
