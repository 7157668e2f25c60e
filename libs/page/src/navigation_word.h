#pragma once
#include <string>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

/** Whether the best map is good enough to drive by, and what that rests on: a sentence or two, by
 *  the table of docs/scoring.md. Empty where there is no best map. */
std::string navigationWord(const Comparison& comparison);

}  // namespace roomgraph
