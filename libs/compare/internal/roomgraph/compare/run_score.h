#pragma once
#include <optional>
#include <vector>

#include "roomgraph/compare/compare_runs.h"
#include "roomgraph/consensus/map_errors.h"
#include "roomgraph/relate/DistinctMaps.h"
#include "roomgraph/relate/PairBend.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// In:   how far each pair of runs bends apart, and how wrong each run is
// Out:  RunScore of each run
// Next: compareRuns

/** Error below which all runs are trusted alike [m]. */
constexpr double kTrustFloor = 0.05;

/** Of each run of a site; none for a reference, and where no wall could be compared. */
using RunScores = std::vector<std::optional<RunScore>>;

/** Scores each run: 100 * exp(-mapError / scoreScale), where the map errors are those of the
 *  consensus. With `reference`, that run is taken for the truth and gets no score itself. Trust
 *  falls with the fourth power of kTrustFloor plus the map error; that of the most trusted run, or
 *  of the reference, is 1, that of a run without leastShare 0, unless all are so. Runs of which no
 *  other has anything have no score. Meaningful with kFewestWalls wall points and leastShare in
 *  common with a reference, or with one other run and with all the rest. `errors` and `maps` are by
 *  run, as `bends`. O(runs^2).
 *  @throws UsageError where `reference` is none of the runs, or errors are not as many as runs. */
RunScores scoreRuns(const PairBends& bends, const DistinctMaps& maps,
                    const std::vector<MapError>& errors, std::optional<std::size_t> reference,
                    const CompareRunsOptions& options);

/** Whom to trust on where things are: the runs as they are scored, or a reference alone. */
Trust trustOf(const RunScores& scores, std::optional<std::size_t> reference);

/** Whose word counts on what there is to be seen: also beside a reference, that of each run. */
Trust witnessesOf(const RunScores& scores, std::optional<std::size_t> reference);

}  // namespace roomgraph
