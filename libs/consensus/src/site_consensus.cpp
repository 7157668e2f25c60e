#include "roomgraph/consensus/site_consensus.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "roomgraph/relate/DistinctMaps.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {
namespace {

/** The runs whose maps are no copies, straightest first: the likeliest to be sound. */
std::vector<std::size_t> distinctRuns(const Site& site, const DistinctMaps& maps) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < site.runs.size(); ++i)
    if (maps.isFirst(i)) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t l, std::size_t r) {
    return site.runs[l]->map.axisDeviation.value_or(M_PI) <
           site.runs[r]->map.axisDeviation.value_or(M_PI);
  });
  return order;
}

/** All matches between the runs named in `order`, by their places there. */
std::vector<RunMatches> matchRuns(const Site& site, const MapPairs& pairs,
                                  const std::vector<std::size_t>& order,
                                  const std::vector<RunSubmaps>& submaps, const ForEach& forEach) {
  const std::size_t n = order.size();
  std::vector<RunMatches> all(n * n);
  forEach(n * n, [&](std::size_t k) {
    const std::size_t a = k / n, b = k % n, i = order[a], j = order[b];
    all[k].of = a, all[k].in = b;
    if (a == b) return;
    const Transform2D whole = site.poses[j].inverse() * site.poses[i];
    all[k].matches = matchSubmaps(*site.runs[i], submaps[a], *site.runs[j], submaps[b],
                                  followedIn(pairs, i, j), whole);
    if (a > b) return;
    const auto same = sameScans(*site.runs[i], *site.runs[j]);
    all[k].matches.insert(all[k].matches.end(), same.begin(), same.end());
  });
  return all;
}

}  // namespace

Consensus siteConsensus(const Site& site, const MapPairs& pairs, const ForEach& forEach) {
  const DistinctMaps maps(bendsOf(pairs));
  const std::vector<std::size_t> order = distinctRuns(site, maps);
  std::vector<RunSubmaps> submaps(order.size());
  forEach(order.size(), [&](std::size_t a) { submaps[a] = runSubmaps(*site.runs[order[a]]); });
  const auto matches = matchRuns(site, pairs, order, submaps, forEach);
  const auto placeOf = [&](std::size_t run) {
    return std::size_t(std::find(order.begin(), order.end(), maps.firstOf(run)) - order.begin());
  };
  ConsensusOptions options;
  if (site.reference) options.reference = placeOf(*site.reference);
  options.forEach = forEach;
  const SubmapPoses poses = findConsensus(submaps, matches, options);
  std::vector<MapError> errors = mapErrors(submaps, matches, poses);
  if (order.size() == 1 && site.runs.size() > 1) errors.front().seen = 1;  // by its copies
  Consensus result;
  for (std::size_t i = 0; i < site.runs.size(); ++i) {
    result.submaps.push_back(submaps[placeOf(i)]);
    result.poses.push_back(poses[placeOf(i)]);
    result.errors.push_back(errors[placeOf(i)]);
  }
  return result;
}

}  // namespace roomgraph
