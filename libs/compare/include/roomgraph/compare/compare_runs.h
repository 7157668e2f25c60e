#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/compare/Comparison.h"
#include "roomgraph/relate/KeptPairs.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

struct MapPairs;

// In:   the runs, as prepareRun makes them
// Out:  Comparison
// Next: comparisonJson, comparisonReport

struct CompareRunsOptions {
  bool areAligned = false;                ///< all maps are in one frame already
  std::optional<std::size_t> reference;   ///< the run to measure the others against
  double scoreScale = 0.5;                ///< map error at which the score is 100 / e [m]
  double leastShare = 0.2;                ///< of walls in common, for a score that is meaningful
  double breakShift = kBreakShift;        ///< from which on a jump of a run is a break [m]
  double breakRotation = kBreakRotation;  ///< the same for one that turns its map [rad]
  KeptPairs kept;              ///< where pairs are kept from call to call; changes nothing
  ForEach forEach = oneByOne;  ///< changes no number
  /** Up to so many runs are related each to each; of more, so many work out the consensus, and the
   *  others are held against it, see relateRuns. At least 3. */
  int core = 12;
};

/** Relates the runs, places them in one frame, scores and measures each, and says which is best.
 *  The site is the largest set of runs that are joined by pairs of the same site (that of the
 *  reference, if any); runs outside of it are left out. A single run gets no score. The same for
 *  any order of the runs.
 *
 *      std::vector<Run> runs{prepareRun("monday", ...), prepareRun("tuesday", ...)};
 *      const Comparison comparison = compareRuns(runs, {});
 *      const std::string best = comparison.runs.front().name;
 *
 *  O(runs * walls), and with the square of the runs up to `core` of them.
 *  @throws UsageError where there is no such reference, or two runs have one name. */
[[nodiscard]] Comparison compareRuns(const std::vector<Run>& runs,
                                     const CompareRunsOptions& options);

/** The same for runs in the order of sortRuns that are related already, as relateRuns gives it.
 *  @throws UsageError also where `related` are not those of as many runs. */
[[nodiscard]] Comparison compareRuns(const std::vector<Run>& runs, const MapPairs& related,
                                     const CompareRunsOptions& options);

}  // namespace roomgraph
