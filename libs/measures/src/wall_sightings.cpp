#include "wall_sightings.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "fitted_measures.h"
#include "roomgraph/align/FullMaps.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/relate/pair_jobs.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {
namespace {

/** Of the walls of each run. */
std::vector<std::vector<bool>> straightOf(const Site& site, const ForEach& forEach) {
  std::vector<std::vector<bool>> straight(site.runs.size());
  forEach(straight.size(), [&](std::size_t run) {
    FullMaps maps;
    straight[run] = straightWalls(maps(site.mapOf(run)));
  });
  return straight;
}

/** The other voices that were related to a run. Beside a run with scans those with far less trust
 *  are none: what such a map lacks tells of itself. Without scans, trust rests on the walls. */
std::vector<std::size_t> othersOf(const SightingTable& sightings, const DistinctMaps& maps,
                                  const Trust& trust, std::size_t run) {
  const double least = sightings.hasScans[run] ? fitted::kLeastTrust * trust[run] : 0;
  std::vector<std::size_t> others;
  for (const std::size_t other : sightings.in.othersOf(run))
    if (maps.isVoice(other) && maps.voiceOf(run) != other && trust[other] >= least)
      others.push_back(other);
  return others;
}

struct Count {
  double all = 0, some = 0;
};

struct Seen {
  std::size_t found = 0, free = 0;  ///< runs that have a wall, and that show free space there
};

/** What `others`, but the run itself, have where a wall of a run is. */
Seen seenBy(const std::vector<std::size_t>& others, const SightingTable& sightings, std::size_t run,
            std::size_t wall) {
  Seen seen;
  for (const std::size_t other : others) {
    if (other == run || wall >= sightings.in(run, other).size()) continue;
    const WallSighting sighting = sightings.in(run, other)[wall];
    seen.found += sighting == WallSighting::found, seen.free += sighting == WallSighting::free;
  }
  return seen;
}

/** Of the straight walls of `other` that a third run has and none denies: those whose place `run`
 *  knows, and those that it lacks. */
Count missingOf(const SightingTable& sightings, const std::vector<std::size_t>& others,
                std::size_t other, std::size_t run) {
  const std::vector<WallSighting>& inRun = sightings.in(other, run);
  Count count;
  for (std::size_t i = 0; i < inRun.size(); ++i) {
    if (inRun[i] == WallSighting::unknown || !sightings.isStraight[other][i]) continue;
    const Seen seen = seenBy(others, sightings, other, i);
    if (seen.found == 0 || seen.free > 0) continue;
    ++count.all, count.some += inRun[i] == WallSighting::found ? 0 : 1;
  }
  return count;
}

/** How many straight wall points of `run` were found in `other`. */
double straightFound(const SightingTable& sightings, std::size_t run, std::size_t other) {
  const std::vector<WallSighting>& inOther = sightings.in(run, other);
  double found = 0;
  for (std::size_t i = 0; i < inOther.size(); ++i)
    found += inOther[i] == WallSighting::found && sightings.isStraight[run][i] ? 1 : 0;
  return found;
}

/** The share of the points of its walls that a run lacks, beside those of the others that were
 *  found in it: 0 where it has half of them, as one lidar sees more points of a wall than another.
 */
double thinnedOf(const SightingTable& sightings, const std::vector<std::size_t>& others,
                 const Trust& trust, std::size_t run) {
  double own = 0, theirs = 0;
  for (const std::size_t other : others) {
    own += trust[other] * sightings.spacing[run] * straightFound(sightings, run, other);
    theirs += trust[other] * sightings.spacing[other] * straightFound(sightings, other, run);
  }
  return own < kMajority * theirs ? 1 - own / theirs : 0;
}

enum class Walls { all, straight };

/** Of the walls of one patch of `run` whose place enough of `others` know, those that none of them
 *  has. */
Count addedIn(const WallPatch& patch, Walls walls, const SightingTable& sightings,
              const std::vector<std::size_t>& others, std::size_t run) {
  Count count;
  for (const std::uint32_t i : patch.own) {
    const Seen seen = seenBy(others, sightings, run, i);
    if (seen.found + seen.free < kFewestOthers) continue;
    const bool isOne = walls == Walls::all || sightings.isStraight[run][i];
    ++count.all, count.some += isOne && seen.found == 0 ? 1 : 0;
  }
  return count;
}

struct Share {
  double value = 0;
  Point place;  ///< the middle of what makes it
};

/** The share among the nearest kFewestWalls to a patch, or among all where there are fewer. */
Share shareRound(std::size_t patch, const WallPatches& patches, const std::vector<Count>& counts) {
  std::vector<std::pair<double, std::size_t>> nearest;
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (counts[p].all > 0)
      nearest.emplace_back(distance(patches[p].middle, patches[patch].middle), p);
  std::sort(nearest.begin(), nearest.end());
  Count sum;
  Point places;
  for (auto it = nearest.begin(); it != nearest.end() && sum.all < kFewestWalls; ++it) {
    const Count& count = counts[it->second];
    sum.all += count.all, sum.some += count.some;
    places = places + count.some * patches[it->second].middle;
  }
  return {sum.some / sum.all, 1 / sum.some * places};
}

MeasuredValue addedOf(Walls walls, const SightingTable& sightings, const DistinctMaps& maps,
                      const Trust& trust, std::size_t run) {
  auto others = othersOf(sightings, maps, trust, run);
  eraseIf(others, [&](std::size_t other) { return trust[other] <= 0; });
  MeasuredValue added;
  added.hasEnoughOthers = others.size() >= kFewestOthers;
  const WallPatches& patches = *sightings.patches[run];
  std::vector<Count> counts;
  for (const WallPatch& patch : patches) {
    counts.push_back(addedIn(patch, walls, sightings, others, run));
    added.support += counts.back().all;
  }
  if (added.support > 0) added.value = 0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (counts[p].some <= 0) continue;
    const Share share = shareRound(p, patches, counts);
    if (share.value > *added.value) added.value = share.value, added.place = share.place;
  }
  return added;
}

}  // namespace

SightingTable wallSightings(const Site& site, const MapPairs& pairs, const ForEach& forEach) {
  const std::size_t n = site.runs.size();
  SightingTable table{
      {n, pairs.pairs()}, {n, pairs.pairs()}, straightOf(site, forEach), {}, {}, {}};
  for (const Run* run : site.runs) {
    table.patches.push_back(&run->map.patches);
    table.hasScans.push_back(!run->scans.empty());
    table.spacing.push_back(std::max(kWallCell, run->resolution));
  }
  visitPairs(site, pairs.pairs(), forEach, [&](std::size_t k, FullMaps& maps) {
    const auto [i, j] = pairs.pairs()[k];
    const WallMap &a = maps(site.mapOf(i)), &b = maps(site.mapOf(j));
    table.in(i, j) = sightWalls(a, b, followedIn(pairs, i, j));
    table.in(j, i) = sightWalls(b, a, followedIn(pairs, j, i));
    const Transform2D bInA = site.poses[i].inverse() * site.poses[j];
    const Transform2D aInB = site.poses[j].inverse() * site.poses[i];
    table.distances(i, j) = wallDistances(a, b, aInB);
    table.distances(j, i) = wallDistances(b, a, bInA);
  });
  return table;
}

MeasuredValue wallsMissingOf(const SightingTable& sightings, const DistinctMaps& maps,
                             const Trust& trust, std::size_t run) {
  const auto others = othersOf(sightings, maps, trust, run);
  const double thinned = thinnedOf(sightings, others, trust, run);
  std::vector<ShareInOther> missing;
  for (const std::size_t other : others) {
    const Count count = missingOf(sightings, others, other, run);
    const double gone = count.some + thinned * (count.all - count.some);
    missing.push_back(
        {trust[other] > 0 ? count.all : 0, trust[other] * gone, trust[other] * count.all});
  }
  return shareOverOthers(missing);
}

MeasuredValue wallsAddedOf(const SightingTable& sightings, const DistinctMaps& maps,
                           const Trust& trust, std::size_t run) {
  return addedOf(Walls::all, sightings, maps, trust, run);
}

MeasuredValue straightWallsAddedOf(const SightingTable& sightings, const DistinctMaps& maps,
                                   const Trust& trust, std::size_t run) {
  return addedOf(Walls::straight, sightings, maps, trust, run);
}

}  // namespace roomgraph
