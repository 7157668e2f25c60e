#pragma once
#include <string>
#include <vector>

#include "roomgraph/archive/FleetTask.h"

namespace roomgraph {

// Ours
// In:   a table of runs
// Out:  ListedRun
// Next: planFleet

/** The runs of a CSV text with a line of column names: site and file, and where they are there
 *  robot and time (see parseTime); other columns are skipped. Cells may be quoted. Files are those
 *  of `folder` where they have no root; a robot without a name is "robot". `name` is that of the
 *  table, for messages.
 *  @throws DataError with the line where a cell is missing or wrong. */
std::vector<ListedRun> readRunList(const std::string& text, const std::string& name,
                                   const std::string& folder);

}  // namespace roomgraph
