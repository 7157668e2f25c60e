#pragma once
#include <string>

#include "roomgraph/archive/add_run.h"
#include "roomgraph/archive/watch_site.h"

namespace roomgraph {

// Ours
// In:   AddedRun, and what its robot's maps say then
// Out:  a line for other programs
// Next: a command that is called

/** One line of JSON of format "roomgraph/watch", version 1; see the schema in
 *  share/roomgraph/schema. `robot` is none where no run of it can be judged. */
std::string addedRunJson(const std::string& file, const AddedRun& run, const RobotWatch* robot);

/** The same of a file that could not be added, and why. */
std::string failedRunJson(const std::string& file, const std::string& error);

}  // namespace roomgraph
