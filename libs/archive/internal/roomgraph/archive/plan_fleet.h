#pragma once
#include <functional>
#include <string>
#include <vector>

#include "roomgraph/archive/FleetTask.h"
#include "roomgraph/compare/compare_maps.h"

namespace roomgraph {

// Ours
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

}  // namespace roomgraph
