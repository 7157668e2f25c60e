#include "roomgraph/consensus/errors_by_bends.h"

#include <algorithm>
#include <map>
#include <optional>

#include "roomgraph/base/sequences.h"
#include "roomgraph/consensus/estimate_map_errors.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {
namespace {

/** The errors of some runs, which are ascending, among themselves. Where the two ways of a pair
 *  leave its bend in doubt, either may be right: the interval holds what follows from both. */
std::vector<std::optional<MapError>> errorsAmong(const std::vector<std::size_t>& some,
                                                 const Site& site, const PairBends& bends) {
  const auto placeOf = [&](std::size_t run) {
    return std::size_t(std::lower_bound(some.begin(), some.end(), run) - some.begin());
  };
  const auto has = [&](std::size_t run) {
    return std::binary_search(some.begin(), some.end(), run);
  };
  const auto told = mapped(some, [&](std::size_t i) { return site.runs[i]->map.axisDeviation; });
  std::vector<PairOfThings> pairs;
  for (const auto& [i, j] : bends.pairs())
    if (has(i) && has(j)) pairs.emplace_back(placeOf(i), placeOf(j));
  PairBends among(some.size(), pairs);
  for (const auto& [i, j] : pairs) among(i, j) = bends(some[i], some[j]);
  std::optional<std::size_t> truth;
  if (site.reference && has(*site.reference)) truth = placeOf(*site.reference);
  std::vector<std::optional<MapError>> errors = estimateMapErrors(among, told, truth);
  const auto isSure = [&](const PairOfThings& pair) {
    return among(pair.first, pair.second).agreement == 1;
  };
  if (allOf(pairs, isSure)) return errors;
  for (const auto& [i, j] : pairs) among(i, j).bend *= among(i, j).agreement;
  const auto otherwise = estimateMapErrors(among, told, truth);  // by the ways that tell less
  for (std::size_t k = 0; k < errors.size(); ++k) {
    if (!errors[k]) continue;
    errors[k]->low = std::min(errors[k]->low, otherwise[k]->low);
    errors[k]->high = std::max(errors[k]->high, otherwise[k]->high);
  }
  return errors;
}

/** The run that speaks for the picture of another one: the reference for its own. Where all are of
 *  one picture, each map speaks for itself. */
std::size_t voiceFor(std::size_t run, const Site& site, const DistinctMaps& maps) {
  const auto voice = [&](std::size_t i) {
    return maps.count() == 1 ? maps.firstOf(i) : maps.voiceOf(i);
  };
  const bool isOfTruth = site.reference && voice(run) == voice(*site.reference);
  return isOfTruth ? *site.reference : voice(run);
}

/** The error of a run, which takes the place of its own voice among the others. */
std::optional<MapError> errorBeside(std::vector<std::size_t> voices, std::size_t run,
                                    const Site& site, const PairBends& bends,
                                    const DistinctMaps& maps) {
  const std::size_t own = voiceFor(run, site, maps);
  if (own != site.reference) eraseIf(voices, [&](std::size_t voice) { return voice == own; });
  const auto place = voices.insert(std::lower_bound(voices.begin(), voices.end(), run), run);
  const auto index = std::size_t(place - voices.begin());
  return errorsAmong(voices, site, bends)[index];
}

/** How far the walls of a run lie from those of that other one that they fit best: what is not
 *  followed, such as the torn end of a map, is in it. */
double leastMisfit(std::size_t run, const PairBends& bends, const DistinctMaps& maps) {
  std::optional<double> least;
  for (const std::size_t other : bends.othersOf(run))
    if (maps.isMeasuredAgainst(run, other) && bends(run, other).share > 0)
      least = std::min(least.value_or(bends(run, other).misfit), bends(run, other).misfit);
  return least.value_or(0);
}

constexpr double kExplained = 3;  // of its error, so far off a wall may lie

/** The share of the walls of a run that were found in another map, no farther from where the whole
 *  lies there than its error explains. */
double foundShare(std::size_t run, double error, const Site& site, const MapPairs& pairs,
                  const DistinctMaps& maps) {
  const WallPatches& patches = site.runs[run]->map.patches;
  std::vector<bool> isFound(patches.size());
  for (const std::size_t other : pairs.othersOf(run)) {
    if (!maps.isMeasuredAgainst(run, other)) continue;
    const FollowedWalls& followed = followedIn(pairs, run, other);
    for (const FollowedPatch& patch : followed.patches) {
      const Point middle = patches[patch.patch].middle;
      if (distance(patch.pose(middle), followed.pose(middle)) <= kExplained * error)
        isFound[patch.patch] = true;
    }
  }
  double found = 0, all = 0;
  for (std::size_t p = 0; p < isFound.size(); ++p) {
    const auto walls = double(patches[p].own.size());
    all += walls, found += isFound[p] ? walls : 0;
  }
  return all > 0 ? found / all : 0;
}

/** What others bear out of a run with scans, beside some without. */
void addConfirmed(const MapError& byScans, MapError& error) {
  error.confirmed = byScans.confirmed, error.contradicted = byScans.contradicted;
  error.isConfirmed = byScans.isConfirmed, error.jitter = byScans.jitter;
  if (error.contradicted > 0) error.high = std::max(error.high, byScans.high);
}

}  // namespace

std::vector<MapError> errorsByBends(const Site& site, const PairBends& bends,
                                    const DistinctMaps& maps) {
  const std::size_t n = bends.things();
  std::vector<std::size_t> voices;
  for (std::size_t i = 0; i < n; ++i)
    if (voiceFor(i, site, maps) == i) voices.push_back(i);
  const auto among = errorsAmong(voices, site, bends);
  std::map<std::size_t, std::optional<MapError>> known;  // of each map
  for (std::size_t k = 0; k < voices.size(); ++k) known[voices[k]] = among[k];
  std::vector<MapError> errors(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t map = maps.firstOf(i);
    const bool isTruth = site.reference && map == maps.firstOf(*site.reference);
    if (known.count(map) == 0) known[map] = errorBeside(voices, map, site, bends, maps);
    if (!isTruth && known[map]) {
      errors[i] = *known[map];
      errors[i].high = std::max(errors[i].high, leastMisfit(i, bends, maps));
    }
    const bool isCopyOfAll = maps.areCopies() && n > 1;
    errors[i].seen = isCopyOfAll ? 1 : isTruth || known[map] ? mostShare(bends, i) : 0;
  }
  return errors;
}

std::vector<MapError> siteErrors(const Site& site, const MapPairs& pairs, const PairBends& bends,
                                 const DistinctMaps& maps, const Consensus& consensus) {
  const auto hasScans = [](const Run* run) { return !run->scans.empty(); };
  std::vector<MapError> errors;
  if (allOf(site.runs, hasScans)) {
    for (std::size_t i = 0; i < site.runs.size(); ++i) errors.push_back(consensus.errorOf(i));
    return errors;
  }
  errors = errorsByBends(site, bends, maps);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (i == site.reference || errors[i].seen <= 0 || maps.areCopies()) continue;
    if (hasScans(site.runs[i]))
      addConfirmed(consensus.errorOf(i), errors[i]);
    else
      errors[i].confirmed = foundShare(i, errors[i].high, site, pairs, maps);
  }
  return errors;
}

}  // namespace roomgraph
