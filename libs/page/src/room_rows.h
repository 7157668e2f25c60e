#pragma once
#include <vector>

#include "roomgraph/base/Json.h"
#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

/** A list with what `toRow` makes of each thing and its place, in their order. */
template <class Things, class ToRow>
Json rowsOf(const Things& things, const ToRow& toRow) {
  Json rows = Json::array();
  for (const auto& thing : things) rows.push_back(toRow(thing, rows.size()));
  return rows;
}

/** The ledger of the page's template, a row for each room: who has seen it, the largest shift, and
 *  in how many runs it is split, merged, or has other doors. */
Json roomRows(const std::vector<SiteRoom>& rooms);

}  // namespace roomgraph
