#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "roomgraph/compare/compare_runs.h"
#include "roomgraph/repair/CarriedPlace.h"
#include "roomgraph/repair/RepairedRun.h"

namespace roomgraph {

// In:   runs, as prepareRun makes them
// Out:  RepairedRun of each, CarriedPlace of each place
// Next: movedRun, mergeRuns

/** Relates runs as compareRuns does, and puts the key frames of each that has scans and lies in
 *  their site where all of them together have them, in the run's own frame; one run alone where it
 *  agrees with itself. In the order of the runs.
 *
 *      for (const RepairedRun& one : repairRuns(runs, {}))
 *        writeFileAtomically(names[one.run], movedRun(runs[one.run], one).simplemap);
 *
 *  Cost: that of compareRuns.
 *  @throws UsageError where there is no such reference. */
[[nodiscard]] std::vector<RepairedRun> repairRuns(const std::vector<Run>& runs,
                                                  const CompareRunsOptions& options);

/** The files of a run whose key frames have moved: the map, packed as it was, and its path, which
 *  begins with a comment on who has written both, and has the SHA-256 of the map. */
struct MovedRun {
  std::string simplemap, tum;
};

/** @throws DataError where the file of the run cannot be read any more. */
[[nodiscard]] MovedRun movedRun(const Run& run, const RepairedRun& repaired);

/** Carries places from run `from` to run `to` of one site, as the maps bend around each place; all
 *  runs help. Cost: that of compareRuns, and O(places * key frames).
 *  @throws UsageError where there is no such run, DataError where one of the two does not lie in
 *  the site. */
[[nodiscard]] std::vector<CarriedPlace> carryPlaces(const std::vector<Place>& places,
                                                    const std::vector<Run>& runs, std::size_t from,
                                                    std::size_t to,
                                                    const CompareRunsOptions& options);

}  // namespace roomgraph
