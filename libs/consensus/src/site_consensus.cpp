#include "roomgraph/consensus/site_consensus.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "lost_scans.h"
#include "roomgraph/align/FullMaps.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/consensus/add_to_consensus.h"
#include "roomgraph/consensus/find_consensus.h"
#include "roomgraph/relate/pair_jobs.h"
#include "roomgraph/relate/place_runs.h"

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

constexpr std::size_t kMostWholes = 12;

/** Where a run may lie in the site as a whole, site <- run, the likeliest first: as it does, and
 *  where the search for its pairs found that it fits as well. A piece of it may lie there. */
std::vector<Transform2D> wholesOf(const Site& site, const MapPairs& pairs, std::size_t run) {
  std::vector<Transform2D> wholes{site.poses[run]};
  const Point middle = site.runs[run]->map.middle();
  std::vector<std::vector<Transform2D>> byPair;
  std::size_t most = 0;
  for (const std::size_t j : pairs.othersOf(run)) {
    const bool isFirst = j < run;
    byPair.emplace_back();
    for (const Transform2D& pose : (isFirst ? pairs(j, run) : pairs(run, j)).alignment.poses)
      byPair.back().push_back(site.poses[j] * (isFirst ? pose : pose.inverse()));
    most = std::max(most, byPair.back().size());
  }
  for (std::size_t rank = 0; rank < most; ++rank)
    for (const std::vector<Transform2D>& poses : byPair) {
      if (rank >= poses.size() || wholes.size() >= kMostWholes) continue;
      if (std::none_of(wholes.begin(), wholes.end(), [&](const Transform2D& known) {
            return areNear(known, poses[rank], middle, kBesideItself);
          }))
        wholes.push_back(poses[rank]);
    }
  return wholes;
}

/** All matches between the runs named in `order` that were related, by their places there. */
std::vector<RunMatches> matchRuns(const Site& site, const MapPairs& pairs,
                                  const std::vector<std::size_t>& order,
                                  const std::vector<RunSubmaps>& submaps, const ForEach& forEach) {
  const std::size_t n = order.size();
  std::vector<std::vector<Transform2D>> wholes;  // site <- run
  for (const std::size_t run : order) wholes.push_back(wholesOf(site, pairs, run));
  std::vector<PairOfThings> related;  // both ways
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b)
      if (a != b && pairs.has(order[a], order[b])) related.emplace_back(a, b);
  const auto matched = [&](std::size_t a, std::size_t b, FullMaps& maps) {
    const std::size_t i = order[a], j = order[b];
    std::vector<Transform2D> wholesInJ;
    for (const Transform2D& whole : wholes[a]) wholesInJ.push_back(site.poses[j].inverse() * whole);
    auto pieces = matchSubmaps(*site.runs[i], submaps[a], maps(site.mapOf(j)), submaps[b],
                               followedIn(pairs, i, j), wholesInJ);
    if (a < b) pieces.push_back({sameScans(*site.runs[i], *site.runs[j]), 0});
    return pieces;
  };
  const auto jobs = pairJobs(related, [&](std::size_t a) { return site.mapOf(order[a]).isBare(); });
  std::vector<std::vector<MatchedPiece>> found(related.size());
  forEach(jobs.size(), [&](std::size_t job) {
    FullMaps maps;
    for (const std::size_t k : jobs[job])
      found[k] = matched(related[k].first, related[k].second, maps);
  });
  std::vector<RunMatches> all;
  for (std::size_t k = 0; k < related.size(); ++k)
    for (MatchedPiece& piece : found[k])
      if (!piece.matches.empty())
        all.push_back(
            {related[k].first, related[k].second, std::move(piece.matches), piece.likeness});
  return all;
}

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
  std::vector<std::vector<RunMatches>> own(submaps.size());
  for (const RunMatches& piece : matches) {
    if (piece.of >= core && piece.in < core) own[piece.of].push_back(piece);
    if (piece.in >= core && piece.of < core) own[piece.in].push_back(piece);
  }
  forEach(submaps.size() - core, [&](std::size_t i) {
    AddedToConsensus added = addToConsensus(submaps, core + i, own[core + i], known);
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
