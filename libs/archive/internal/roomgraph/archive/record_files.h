#pragma once
#include <functional>
#include <string>
#include <vector>

#include "roomgraph/archive/Archive.h"

namespace roomgraph {

// Ours
// In:   the runs of a site, and their files
// Out:  those of them that a new run can be compared with
// Next: addRun

/** The choice of chooseRecord among the runs whose files are there and hold what they held.
 *  `onMissing` is told of each that was asked for in vain. */
std::vector<KnownRun> recordRuns(const std::vector<KnownRun>& runs, std::size_t most,
                                 const std::function<void(const KnownRun&)>& onMissing);

/** When a run was made [s since 1970]: the time of its first scan, else that of its file.
 *  @throws DataError where it cannot be read. */
double runTime(const std::string& file);

}  // namespace roomgraph
