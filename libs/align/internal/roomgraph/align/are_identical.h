#pragma once
#include "roomgraph/align/WallMap.h"

namespace roomgraph {

/** Whether two maps are the same, cell by cell and wall by wall. */
bool areIdentical(const WallMap& l, const WallMap& r);

}  // namespace roomgraph
