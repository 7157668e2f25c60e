#include "roomgraph/repair/repair_site.h"

#include <algorithm>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/check/check_run.h"
#include "roomgraph/graph_files/ros_map.h"
#include "roomgraph/relate/relate_runs.h"
#include "roomgraph/repair/carry_places.h"
#include "roomgraph/repair/key_frame_moves.h"
#include "roomgraph/repair/repair_runs.h"
#include "roomgraph/repair/solve_runs.h"
#include "roomgraph/scans/read_simplemap.h"

namespace roomgraph {
namespace {

std::size_t placeIn(const Site& site, const std::vector<Run>& runs, std::size_t run) {
  if (run >= runs.size()) throw UsageError("carry_places: there is no run " + std::to_string(run));
  if (site.has(run))
    return std::size_t(std::lower_bound(site.members.begin(), site.members.end(), run) -
                       site.members.begin());
  throw DataError(runs[run].name + ": does not lie in the site of the others: give runs that do");
}

}  // namespace

SolvedSite solveRuns(const std::vector<Run>& runs, const CompareRunsOptions& options,
                     bool areOneSite) {
  if (options.reference && *options.reference >= runs.size())
    throw UsageError("solve_runs: there is no run " + std::to_string(*options.reference));
  const RelateRunsOptions relating{options.areAligned, options.reference, std::size_t(options.core),
                                   areOneSite};
  const MapPairs related = relateRuns(runs, relating, options.forEach, options.kept);
  return solveSite(runs, related, options.reference, options.forEach);
}

std::vector<RepairedRun> repairRuns(const std::vector<Run>& runs,
                                    const CompareRunsOptions& options) {
  if (runs.size() == 1 && !options.reference && !runs.front().scans.empty())
    return {repairAlone(runs.front(), checkRun(runs.front()))};
  const SolvedSite solved = solveRuns(runs, options);
  return repairRuns(solved, rejoinPieces(solved));
}

MovedRun movedRun(const Run& run, const RepairedRun& repaired) {
  CheckedFile file(run.file);
  const Recording recording = readSimplemap(file);
  const std::vector<PoseMove> moves = keyFrameMoves(run, repaired, recording);
  const std::string content = movePoses(file.content(), recording, moves);
  MovedRun moved;
  moved.simplemap = packedMap(content, file.compression());
  moved.tum = std::string(kRosMapMark) + "\n# Its simplemap has the SHA-256 " +
              sha256Of(viewOf(moved.simplemap)) + ".\n" + trajectoryTum(recording, moves);
  return moved;
}

std::vector<CarriedPlace> carryPlaces(const std::vector<Place>& places,
                                      const std::vector<Run>& runs, std::size_t from,
                                      std::size_t to, const CompareRunsOptions& options) {
  const SolvedSite solved = solveRuns(runs, options, runs.size() == 2);
  return carryPlaces(places, solved, rejoinPieces(solved), placeIn(solved.site, runs, from),
                     placeIn(solved.site, runs, to), options.forEach);
}

}  // namespace roomgraph
