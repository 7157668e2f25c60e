#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "roomgraph/breaks/find_breaks.h"
#include "roomgraph/breaks/find_pieces.h"
#include "roomgraph/compare/Comparison.h"
#include "roomgraph/relate/PreparedRun.h"
#include "roomgraph/relate/relate_runs.h"
#include "roomgraph/relate/site_poses.h"
#include "roomgraph/score/run_score.h"

namespace roomgraph {

// Ours
// In:   the runs, and how each pair of them lies in each other
// Out:  Comparison
// Next: comparisonJson

struct CompareRunsOptions {
  SitePosesOptions poses;
  RunScoreOptions score;
  TrackScansOptions trackScans;
  FindBreaksOptions findBreaks;
  FindPiecesOptions findPieces;
  std::optional<std::size_t> reference;  ///< the run to measure the others against
  ForEach forEach = oneByOne;            ///< changes no number
};

/** Places the runs in one frame, scores and measures each, and says which is best. `related` are
 *  those of relateRuns. The site is the largest set of
 * runs that are joined by pairs of the same site (that of the reference, if any; of equal ones the
 * surest); runs outside of it are left out. The site's frame is that of its run that the others fit
 * best, or of the reference. A single run gets no score. O(runs^2 * walls).
 *  @throws UsageError where `related` are not as many as the pairs, or there is no reference.
 */
Comparison compareRuns(const std::vector<PreparedRun>& runs, const std::vector<MapPair>& related,
                       const CompareRunsOptions& options);

}  // namespace roomgraph
