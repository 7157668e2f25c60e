#pragma once
#include <string>
#include <vector>

#include "roomgraph/archive/FleetTask.h"
#include "roomgraph/compare/compare_maps.h"

namespace roomgraph {

// Ours
// In:   FleetTask
// Out:  Comparison
// Next: Archive

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
