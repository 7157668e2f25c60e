#include "roomgraph/consensus/site_consensus.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "lost_scans.h"
#include "match_runs.h"
#include "roomgraph/consensus/add_to_consensus.h"
#include "roomgraph/consensus/find_consensus.h"

namespace roomgraph {
namespace {

/** For each run the one that counts of those with its map: the first with as many scans; for one
 *  without scans the first that has some, as they tell more. */
std::vector<std::size_t> standIns(const Site& site, const DistinctMaps& maps) {
  const auto scansOf = [&](std::size_t run) { return site.runs[run]->scans.size(); };
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < site.runs.size(); ++i) {
    chosen.push_back(maps.firstOf(i));
    for (std::size_t j = site.runs.size(); j-- > 0;)
      if (maps.firstOf(j) == maps.firstOf(i) &&
          (scansOf(i) > 0 ? scansOf(j) == scansOf(i) : scansOf(j) > 0))
        chosen.back() = j;
  }
  return chosen;
}

/** The runs that count, those first among which the consensus is worked out, each straightest
 *  first: the likeliest to be sound. */
struct CountedRuns {
  std::vector<std::size_t> order;
  std::size_t core = 0;  ///< so many of them are the core

  CountedRuns(const Site& site, const MapPairs& pairs, const std::vector<std::size_t>& standIns) {
    std::set<std::size_t> first;
    for (const std::size_t run : pairs.core) first.insert(standIns[run]);
    const std::set<std::size_t> distinct(standIns.begin(), standIns.end());
    order.assign(distinct.begin(), distinct.end());
    const auto key = [&](std::size_t run) {
      return std::make_pair(first.count(run) == 0,
                            site.runs[run]->map.axisDeviation.value_or(M_PI));
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t l, std::size_t r) { return key(l) < key(r); });
    core = first.empty() ? order.size() : first.size();
  }
};

/** Lets the intervals hold what another solution has, which may be the right one. */
void widen(std::vector<MapError>& errors, const std::vector<MapError>& others) {
  for (std::size_t i = 0; i < errors.size(); ++i) {
    errors[i].low = std::min(errors[i].low, others[i].low);
    errors[i].high = std::max(errors[i].high, others[i].high);
  }
}

/** What all runs that count agree on, in their order. */
struct Agreement {
  SubmapPoses poses;
  std::vector<MapError> errors;
};

/** The first `core` runs agree among themselves, from one or another start. */
std::vector<Agreement> agreementsOf(const std::vector<RunSubmaps>& submaps, std::size_t core,
                                    const std::vector<RunMatches>& matches,
                                    const ConsensusOptions& options) {
  const std::vector<RunSubmaps> first(submaps.begin(), submaps.begin() + std::ptrdiff_t(core));
  std::vector<RunMatches> among;
  for (const RunMatches& piece : matches)
    if (piece.of < core && piece.in < core) among.push_back(piece);
  ConsensusPoses found = findConsensus(first, among, options);
  std::vector<Agreement> all;
  all.push_back({std::move(found.best), {}});
  for (SubmapPoses& other : found.others) all.push_back({std::move(other), {}});
  for (Agreement& one : all) one.errors = mapErrors(first, among, one.poses);
  return all;
}

/** Adds the other runs, each by itself. */
void addOthers(Agreement& agreement, const std::vector<RunSubmaps>& submaps,
               const std::vector<RunMatches>& matches, const ForEach& forEach) {
  const std::size_t core = agreement.poses.size();
  agreement.poses.resize(submaps.size());
  agreement.errors.resize(submaps.size());
  const SubmapPoses& known = agreement.poses;
  std::vector<std::vector<const RunMatches*>> own(submaps.size());
  for (const RunMatches& piece : matches) {
    if (piece.of >= core && piece.in < core) own[piece.of].push_back(&piece);
    if (piece.in >= core && piece.of < core) own[piece.in].push_back(&piece);
  }
  forEach(submaps.size() - core, [&](std::size_t i) {
    std::vector<RunMatches> matchesOfIt;
    for (const RunMatches* piece : own[core + i]) matchesOfIt.push_back(*piece);
    AddedToConsensus added = addToConsensus(submaps, core + i, matchesOfIt, known);
    agreement.poses[core + i] = std::move(added.poses);
    agreement.errors[core + i] = std::move(added.error);
  });
}

}  // namespace

Consensus siteConsensus(const Site& site, const MapPairs& pairs, const DistinctMaps& maps,
                        const ForEach& forEach) {
  const std::size_t runs = site.runs.size();
  if (std::all_of(site.runs.begin(), site.runs.end(),
                  [](const Run* r) { return r->scans.empty(); }))
    return {std::vector<RunSubmaps>(runs), SubmapPoses(runs), std::vector<MapError>(runs)};
  const std::vector<std::size_t> counted = standIns(site, maps);
  const CountedRuns runsThatCount(site, pairs, counted);
  const std::vector<std::size_t>& order = runsThatCount.order;
  std::vector<RunSubmaps> submaps(order.size());
  forEach(order.size(), [&](std::size_t a) { submaps[a] = runSubmaps(*site.runs[order[a]]); });
  const auto matches = matchRuns(site, pairs, order, submaps, forEach);
  const auto placeOf = [&](std::size_t run) {
    return std::size_t(std::find(order.begin(), order.end(), counted[run]) - order.begin());
  };
  ConsensusOptions options;
  if (site.reference) options.reference = placeOf(*site.reference);
  options.forEach = forEach;
  std::vector<Agreement> agreements = agreementsOf(submaps, runsThatCount.core, matches, options);
  for (Agreement& one : agreements) addOthers(one, submaps, matches, forEach);
  std::vector<MapError>& errors = agreements.front().errors;
  for (std::size_t k = 1; k < agreements.size(); ++k) widen(errors, agreements[k].errors);
  if (order.size() == 1 && site.runs.size() > 1) errors.front().seen = 1;  // by its copies
  Consensus result;
  for (std::size_t i = 0; i < site.runs.size(); ++i) {
    result.submaps.push_back(submaps[placeOf(i)]);
    result.poses.push_back(agreements.front().poses[placeOf(i)]);
    result.errors.push_back(errors[placeOf(i)]);
  }
  const std::vector<std::vector<bool>> lost = lostScans(site, pairs, counted, result);
  for (std::size_t i = 0; i < lost.size(); ++i)
    addLost(result.errors[i], result.submaps[i], lost[counted[i]]);
  return result;
}

}  // namespace roomgraph
