#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "roomgraph/archive/Archive.h"
#include "roomgraph/compare/compare_maps.h"

namespace roomgraph {

/** Sites with a run of each that a list names. Its hash is not known yet, and its time is NaN where
 *  the list does not tell. */
using RunList = std::vector<std::pair<std::string, HistoryRun>>;

/** What is to be done for one site: its new runs are compared with each other and with the record.
 *  The same task gives the same bytes wherever and however often it is done. */
struct FleetTask {
  std::string site;
  /** Hash of the maps, their names, all options and the program's version: 64 hex digits. */
  std::string key;
  std::vector<HistoryRun> runs;  ///< the new ones first
  std::size_t newRuns = 0;       ///< how many are new
};

/** One line of JSON for each task. */
std::string taskLines(const std::vector<FleetTask>& tasks);

/** The tasks of such a text. `name` is that of the file, for messages.
 *  @throws DataError with the line where it is no task. */
std::vector<FleetTask> parseTaskLines(const std::string& text, const std::string& name);

/** What came out of a task. */
struct TaskResult {
  Comparison comparison;
  std::vector<std::string> failures;  ///< a line for each map that could not be used
};

/** Compares the runs of a task. A map that cannot be read, or is another one than was planned, is
 *  left out and named. The same for any number of threads.
 *  @throws DataError where no map at all can be used, or the options are not those that the task
 *  was planned with. */
TaskResult doTask(const FleetTask& task, const CompareMapsOptions& options);

}  // namespace roomgraph
