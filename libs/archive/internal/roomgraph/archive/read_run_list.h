#pragma once
#include <functional>
#include <string>

#include "roomgraph/archive/FleetTask.h"

namespace roomgraph {

// Ours
// In:   a table of runs
// Out:  RunList
// Next: planFleet

/** The runs of a CSV text with a line of column names: site and file, and where they are there
 *  robot and time (see parseTime); other columns are skipped. Cells may be quoted. Files are those
 *  of `folder` where they have no root; a robot without a name is "robot". `name` is that of the
 *  table, for messages. A line with a missing or wrong cell costs itself alone: `onBadLine` is told
 *  of it.
 *  @throws DataError where there are no such columns, or no line is left: the program that wrote
 *  the list has failed. */
RunList readRunList(const std::string& text, const std::string& name, const std::string& folder,
                    const std::function<void(const std::string&)>& onBadLine);

}  // namespace roomgraph
