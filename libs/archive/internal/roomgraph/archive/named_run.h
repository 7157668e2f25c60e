#pragma once
#include <string>
#include <vector>

#include "roomgraph/archive/SiteHistory.h"

namespace roomgraph {

// Ours
// In:   the runs of an archive, and what somebody calls one of them
// Out:  HistoryRun
// Next: Archive::removeRun, carryThings

/** The run whose file as listed, the name of that file, or at least eight digits of its SHA-256 is
 *  `name`. `archive` is named in errors.
 *  @throws DataError where there is no such run, or where several could be meant. */
const HistoryRun& namedRun(const std::vector<HistoryRun>& runs, const std::string& name,
                           const std::string& archive);

}  // namespace roomgraph
