#pragma once
#include <string>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

/** The call of the program that repeats a comparison, as a shell takes it: its maps by the names of
 *  their files, by name, and all options that differ from the defaults. */
std::string commandLine(const Comparison& comparison);

}  // namespace roomgraph
