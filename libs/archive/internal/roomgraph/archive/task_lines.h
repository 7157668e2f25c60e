#pragma once
#include <string>
#include <vector>

#include "roomgraph/archive/FleetTask.h"

namespace roomgraph {

// Ours
// In:   FleetTask, or its text
// Out:  its text, or FleetTask
// Next: a file, or doTask

/** One line of JSON for each task. */
std::string taskLines(const std::vector<FleetTask>& tasks);

/** The tasks of such a text. `name` is that of the file, for messages.
 *  @throws DataError with the line where it is no task. */
std::vector<FleetTask> parseTaskLines(const std::string& text, const std::string& name);

}  // namespace roomgraph
