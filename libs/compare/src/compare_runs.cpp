#include "roomgraph/compare/compare_runs.h"

#include <algorithm>
#include <set>
#include <string>

#include "ask_reference.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/return_memory.h"
#include "roomgraph/breaks/site_breaks.h"
#include "roomgraph/check/find_refuted.h"
#include "roomgraph/compare/run_score.h"
#include "roomgraph/consensus/agreed_bends.h"
#include "roomgraph/consensus/errors_by_bends.h"
#include "roomgraph/consensus/site_consensus.h"
#include "roomgraph/ledger/site_rooms.h"
#include "roomgraph/measures/measure_site.h"
#include "roomgraph/relate/place_runs.h"
#include "roomgraph/relate/relate_runs.h"
#include "summarize.h"

namespace roomgraph {
namespace {

void check(const std::vector<Run>& runs, const MapPairs& related,
           const CompareRunsOptions& options) {
  if (related.things() != runs.size())
    throw UsageError("compare_runs: there are " + std::to_string(runs.size()) + " runs, but " +
                     std::to_string(related.things()) + " were related");
  std::set<std::string> names;
  for (const Run& run : runs)
    if (!names.insert(run.name).second)
      throw UsageError("compare_runs: two runs are named " + run.name + ": name them differently");
  if (options.reference && *options.reference >= runs.size())
    throw UsageError("compare_runs: there is no run " + std::to_string(*options.reference));
}

/** The place at which a run comes to be by sortRuns. */
std::optional<std::size_t> placeOf(const std::optional<std::size_t>& run,
                                   const std::vector<Run>& before, const std::vector<Run>& after) {
  if (!run || *run >= before.size()) return run;
  return std::size_t(findRun(after, before[*run].name) - after.data());
}

}  // namespace

Comparison compareRuns(const std::vector<Run>& runs, const MapPairs& related,
                       const CompareRunsOptions& options) {
  check(runs, related, options);
  const ForEach& forEach = options.forEach;
  // Every function here has its section in docs/method.md.
  const Site site = placeRuns(runs, related, options.reference);
  const MapPairs pairs = pairsInSite(site, related, forEach);
  const PairBends drawn = bendsOf(pairs);
  const DistinctMaps maps(drawn);
  const Consensus consensus = siteConsensus(site, pairs, maps, forEach);
  returnMemory();  // of hundreds of runs, what it is worked out from is much
  std::vector<MapError> errors = siteErrors(site, pairs, drawn, maps, consensus);
  const auto welded = findRefuted(site, consensus, forEach);
  for (std::size_t i = 0; i < welded.size(); ++i)
    if (welded[i]) errors[i] = {};  // how far it is off does not show
  const PairBends bends = agreedBends(site, consensus, drawn);
  RunScores scores = scoreRuns(bends, maps, errors, site.reference, options);
  const Trust trust = trustOf(scores, site.reference);
  const FindBreaksOptions breaking{options.breakRotation, options.breakShift};
  auto breaks = siteBreaks(site, pairs, consensus, trust, breaking, forEach);
  const ReferenceFaults faults = askReference(site, scores);
  if (site.reference) breaks[*site.reference] = faults.breaks;
  const Trust witnesses = witnessesOf(scores, site.reference);
  const SiteMeasures measures =
      measureSite(site, pairs, bends, maps, trust, witnesses, breaks, forEach);
  const std::vector<SiteRoom> rooms = siteRooms(site, consensus, trust, forEach);
  returnMemory();
  return summarize(
      runs, related,
      {site, pairs, consensus, scores, breaks, measures, rooms, faults.doubled, welded});
}

Comparison compareRuns(const std::vector<Run>& runs, const CompareRunsOptions& options) {
  if (!std::is_sorted(runs.begin(), runs.end(), isBefore)) {
    std::vector<Run> sorted = runs;
    sortRuns(sorted);
    CompareRunsOptions again = options;
    again.reference = placeOf(options.reference, runs, sorted);
    return compareRuns(sorted, again);
  }
  const RelateRunsOptions relating{options.areAligned, options.reference,
                                   std::size_t(options.core)};
  return compareRuns(runs, relateRuns(runs, relating, options.forEach, options.kept), options);
}

}  // namespace roomgraph
