#pragma once
#include <vector>

#include "roomgraph/relate/Run.h"

namespace roomgraph {

/** All runs, those first whose maps others are best laid on: first those that have seen at least
 *  half as much as the largest, each group by how straight its walls are; equal ones in their
 *  order. */
std::vector<std::size_t> byStraightness(const std::vector<Run>& runs);

}  // namespace roomgraph
