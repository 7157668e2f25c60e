#pragma once
#include <vector>

#include "kainjow/mustache.hpp"
#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

/** The ledger of the page's template, a row for each room: who has seen it, the largest shift, and
 *  in how many runs it is split, merged, or has other doors. */
kainjow::mustache::data roomRows(const std::vector<SiteRoom>& rooms);

}  // namespace roomgraph
