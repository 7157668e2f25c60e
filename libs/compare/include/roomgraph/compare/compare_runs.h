#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/compare/MapForAlignment.h"
#include "roomgraph/compare/relate_maps.h"
#include "roomgraph/compare/run_score.h"
#include "roomgraph/compare/site_poses.h"
#include "roomgraph/rooms/RoomGraph.h"

namespace roomgraph {

// Ours
// In:   the runs, and how each pair of them lies in each other
// Out:  Comparison
// Next: comparisonJson

/** What the comparison needs to know of a run. */
struct PreparedRun {
  std::string name, file, sha256;
  MapForAlignment map;           ///< must have walls
  std::vector<GraphRoom> rooms;  ///< in the frame of the run
};

struct CompareRunsOptions {
  SitePosesOptions poses;
  RunScoreOptions score;
  std::optional<std::size_t> reference;  ///< the run to measure the others against
};

/** Brings runs into the order that all results are computed in, by content and then by name, so
 * that the order in which they are given changes no number. */
void sortRuns(std::vector<PreparedRun>& runs);

/** Both indices of each pair of `runs` runs, a < b, by a and then b. */
std::vector<std::pair<std::size_t, std::size_t>> pairsOf(std::size_t runs);

/** Places the runs in one frame, scores and measures each, and says which is best. `related` are
 *  those of pairsOf(runs.size()), in that order, see relateMaps. The site is the largest set of
 * runs that are joined by pairs of the same site (that of the reference, if any; of equal ones the
 * surest); runs outside of it are left out. The site's frame is that of its run that the others fit
 * best, or of the reference. A single run gets no score. O(runs^2 * walls).
 *  @throws UsageError where `related` are not as many as the pairs, or there is no reference.
 */
Comparison compareRuns(const std::vector<PreparedRun>& runs, const std::vector<MapPair>& related,
                       const CompareRunsOptions& options);

}  // namespace roomgraph
