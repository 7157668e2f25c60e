#pragma once
#include <string>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

/** What stands for the report where roomgraph was built without mustache, Leaflet and D3: one HTML
 *  file with the verdict, what stands out, and a sentence on what is missing. */
std::string bareReport(const Comparison& comparison);

}  // namespace roomgraph
