#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "roomgraph/archive/Archive.h"
#include "roomgraph/archive/SiteHistory.h"

namespace roomgraph {

// In:   the runs of a site, and their files
// Out:  those of them that a new run can be compared with
// Next: addRun

/** The choice of chooseRecord among the runs whose files are there and hold what they held.
 *  `onMissing` is told of each that was asked for in vain. */
std::vector<HistoryRun> recordRuns(const std::vector<HistoryRun>& runs, std::size_t most,
                                   const std::function<void(const HistoryRun&)>& onMissing);

/** When a run was made [s since 1970]: the time of its first scan, else that of its file.
 *  @throws DataError where it cannot be read. */
double runTime(const std::string& file);

// In:   a map file
// Out:  the name of a copy of it
// Next: addRun

/** Copies a map, and the picture of a ROS map, to a folder of its own in `folder`, which is named
 *  after its content, and returns the name of the copy. What is there already stays. `sha256` is
 *  what the content should be, see mapSha256. Written so that a copy is whole or not there.
 *  @throws DataError where it cannot be read or written, is another map now, or names a picture
 *  outside of its folder. */
std::string keepMap(const std::string& file, const std::string& sha256, const std::string& folder);

/** At most `most` indices into `runs` (which stand in the order of time), in their order: first up
 *  to a third that lie elsewhere and have come since the last run of the site, or are no fewer than
 *  its runs, as they may be the site, and it wrong; of the rest half are the latest, then those
 *  with the least map error, without breaks, then more of the latest; all of them among the last
 *  hundred. Other runs of another site are none of them, nor those that are not `isUsable`, which
 *  is asked of no more runs than needed. */
std::vector<std::size_t> chooseRecord(const std::vector<HistoryRun>& runs, std::size_t most,
                                      const std::function<bool(const HistoryRun&)>& isUsable);

}  // namespace roomgraph
