#pragma once
#include <functional>
#include <string>
#include <vector>

#include "roomgraph/archive/FleetTask.h"
#include "roomgraph/compare/compare_maps.h"

namespace roomgraph {

// In:   RunList, Archive
// Out:  FleetTask
// Next: taskLines, doTask

struct PlanFleetOptions {
  std::size_t most = 8;        ///< runs of the archive that those of a site are compared with
  CompareMapsOptions compare;  ///< what the tasks are done with
  /** Told of each listed run whose file cannot be read, with a line that names site, file and
   *  problem. */
  std::function<void(const std::string& line)> onUnread = [](const std::string&) {};
  /** Told of each run of the archive whose file is gone or another one. */
  std::function<void(const HistoryRun&)> onMissing = [](const HistoryRun&) {};
};

/** A task for each site of which a run is listed that the archive does not know, by site. A site of
 *  which nothing is new has none. Reads each listed file once, to tell it by its content. */
std::vector<FleetTask> planFleet(const RunList& listed, const Archive& archive,
                                 const PlanFleetOptions& options);

/** The key of a task with these options, see FleetTask. */
std::string keyOf(const FleetTask& task, const CompareMapsOptions& options);

/** The runs of a CSV text with a line of column names in letters of either case: site and
 *  file, and where they are there robot and time (see parseTime); other columns are skipped. Cells
 *  may be quoted. Files are those of `folder` where they have no root; a robot without a name is
 *  "robot". `name` is that of the table, for messages. A line with a missing or wrong cell costs
 *  itself alone: `onBadLine` is told of it; a quote that is not closed costs all behind it.
 *  @throws DataError where there are no such columns, or no line is left: the program that wrote
 *  the list has failed. */
RunList readRunList(const std::string& text, const std::string& name, const std::string& folder,
                    const std::function<void(const std::string&)>& onBadLine);

}  // namespace roomgraph
