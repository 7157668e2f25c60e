#pragma once
#include "roomgraph/align/MapForAlignment.h"

namespace roomgraph {

/** Whether two maps are the same, cell by cell and wall by wall. */
bool areIdentical(const MapForAlignment& l, const MapForAlignment& r);

}  // namespace roomgraph
