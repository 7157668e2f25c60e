#pragma once
#include "roomgraph/base/Json.h"
#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

/** The values that the page's template asks for, all but its styles, scripts and pictures: texts,
 *  flags, and lists of rows. The template escapes them. */
Json pageTables(const Comparison& comparison);

/** The ledger of the template, a row for each room: who has seen it, the largest shift, and in how
 *  many runs it is split, merged, or has other doors. */
Json roomRows(const std::vector<SiteRoom>& rooms);

}  // namespace roomgraph
