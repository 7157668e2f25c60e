#include "wall_sightings.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "measure_over_others.h"
#include "roomgraph/align/FullMaps.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/relate/pair_jobs.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {
namespace {

constexpr double kSameWallIfBent = 0.3;  // how far apart the same wall may lie where maps bend [m]
constexpr std::size_t kConfirm = 2;      // voices that make sure of a wall, or of free space

/** For each patch of a map where the nearest one that was found lies in another map. */
std::vector<Transform2D> posesOfPatches(const WallMap& map, const FollowedWalls& followed) {
  std::vector<Transform2D> poses;
  for (const WallPatch& patch : map.patches) {
    double nearest = std::numeric_limits<double>::infinity();
    poses.push_back(followed.pose);
    for (const FollowedPatch& found : followed.patches) {
      const double far = distance(map.patches[found.patch].middle, patch.middle);
      if (found.layer == 0 && far < nearest) nearest = far, poses.back() = found.pose;
    }
  }
  return poses;
}

/** Whether a wall goes on straight for 2 m, to one side, to the other, or to both: furniture, which
 *  moves, seldom does. */
bool isStraight(const WallMap& map, const WallPoint& wall) {
  constexpr int kSteps = 20, kMostGaps = 2;  // of 0.1 m; nearer than kSameWall is on the line
  const Point along = 0.1 * Point{-wall.normal.y, wall.normal.x};
  for (const int first : {-kSteps, -kSteps / 2, 0}) {
    int gaps = 0;
    for (int step = first; step <= first + kSteps && gaps <= kMostGaps; ++step) {
      const Point at = wall.place + double(step) * along;
      const WallPoint* next = nearestWall(map, cellIndexAt(map.frame, at), wall.normal);
      gaps += !next || distance(next->place, at) >= kSameWall;
    }
    if (gaps <= kMostGaps) return true;
  }
  return false;
}

/** What `in` has at a place. */
WallSighting sightingAt(const WallMap& in, Point at, Point normal) {
  const std::size_t cell = cellIndexAt(in.frame, at);
  if (cell >= in.states.size()) return WallSighting::unknown;
  const WallPoint* wall = nearestWall(in, cell, normal);
  if (wall && distance(wall->place, at) < kSameWallIfBent) return WallSighting::found;
  return in.depths[cell] > kSameWallIfBent ? WallSighting::free : WallSighting::unknown;
}

std::vector<WallSighting> sightingsIn(const WallMap& of, const WallMap& in,
                                      const FollowedWalls& followed) {
  std::vector<WallSighting> seen(of.walls.size(), WallSighting::unknown);
  if (followed.patches.empty()) return seen;
  const std::vector<Transform2D> poses = posesOfPatches(of, followed);
  for (std::size_t p = 0; p < poses.size(); ++p) {
    const Motion2D motion(poses[p]);
    for (const std::uint32_t i : of.patches[p].own)
      seen[i] = sightingAt(in, motion(of.walls[i].place), motion.turned(of.walls[i].normal));
  }
  return seen;
}

/** Of the walls of each run. */
std::vector<std::vector<bool>> straightWalls(const Site& site, const ForEach& forEach) {
  std::vector<std::vector<bool>> straight(site.runs.size());
  forEach(straight.size(), [&](std::size_t run) {
    FullMaps maps;
    const WallMap& map = maps(site.mapOf(run));
    for (const WallPoint& wall : map.walls) straight[run].push_back(isStraight(map, wall));
  });
  return straight;
}

/** The other voices that were related to a run. */
std::vector<std::size_t> othersOf(const SightingTable& sightings, const DistinctMaps& maps,
                                  std::size_t run) {
  std::vector<std::size_t> others;
  for (const std::size_t other : sightings.in.othersOf(run))
    if (maps.isVoice(other) && maps.voiceOf(run) != other) others.push_back(other);
  return others;
}

struct Count {
  double all = 0, some = 0;
};

/** Of the straight walls of `other` that a third run has: those whose place `run` knows, and those
 *  that it lacks. */
Count missingOf(const SightingTable& sightings, const std::vector<std::size_t>& others,
                std::size_t other, std::size_t run) {
  const std::vector<WallSighting>& inRun = sightings.in(other, run);
  Count count;
  for (std::size_t i = 0; i < inRun.size(); ++i) {
    if (inRun[i] == WallSighting::unknown || !sightings.isStraight[other][i]) continue;
    const bool isConfirmed = std::any_of(others.begin(), others.end(), [&](std::size_t third) {
      if (third == other) return false;
      const auto& inThird = sightings.in(other, third);
      return i < inThird.size() && inThird[i] == WallSighting::found;
    });
    if (!isConfirmed) continue;
    ++count.all, count.some += inRun[i] == WallSighting::free ? 1 : 0;
  }
  return count;
}

/** Of the walls of `run` whose place enough of `others` know, those that none of them has. */
Count addedBy(const SightingTable& sightings, const std::vector<std::size_t>& others,
              std::size_t run) {
  Count count;
  const std::size_t walls = others.empty() ? 0 : sightings.in(run, others.front()).size();
  for (std::size_t i = 0; i < walls; ++i) {
    std::size_t found = 0, free = 0;
    for (const std::size_t other : others) {
      const WallSighting seen = sightings.in(run, other)[i];
      found += seen == WallSighting::found, free += seen == WallSighting::free;
    }
    if (found + free < kConfirm) continue;
    ++count.all, count.some += found == 0 ? 1 : 0;
  }
  return count;
}

}  // namespace

SightingTable wallSightings(const Site& site, const MapPairs& pairs, const ForEach& forEach) {
  SightingTable table{{site.runs.size(), pairs.pairs()}, straightWalls(site, forEach)};
  const auto jobs = pairJobs(pairs.pairs(), [&](std::size_t i) { return site.mapOf(i).isBare(); });
  forEach(jobs.size(), [&](std::size_t job) {
    FullMaps maps;
    for (const std::size_t k : jobs[job]) {
      const auto [i, j] = pairs.pairs()[k];
      const WallMap &a = maps(site.mapOf(i)), &b = maps(site.mapOf(j));
      table.in(i, j) = sightingsIn(a, b, followedIn(pairs, i, j));
      table.in(j, i) = sightingsIn(b, a, followedIn(pairs, j, i));
    }
  });
  return table;
}

MeasuredValue wallsMissingOf(const SightingTable& sightings, const DistinctMaps& maps,
                             const Trust& trust, std::size_t run) {
  const auto others = othersOf(sightings, maps, run);
  std::vector<Count> counts;
  std::vector<double> supports;
  for (const std::size_t other : others) {
    counts.push_back(missingOf(sightings, others, other, run));
    supports.push_back(trust[other] > 0 ? counts.back().all : 0);
  }
  return measureOverOthers(supports, [&](std::size_t but) -> std::optional<double> {
    Count sum;
    for (std::size_t k = 0; k < others.size(); ++k) {
      if (k == but) continue;
      sum.all += trust[others[k]] * counts[k].all, sum.some += trust[others[k]] * counts[k].some;
    }
    if (sum.all <= 0) return std::nullopt;
    return sum.some / sum.all;
  });
}

MeasuredValue wallsAddedOf(const SightingTable& sightings, const DistinctMaps& maps,
                           const Trust& trust, std::size_t run) {
  auto others = othersOf(sightings, maps, run);
  const auto isDistrusted = [&](std::size_t other) { return trust[other] <= 0; };
  others.erase(std::remove_if(others.begin(), others.end(), isDistrusted), others.end());
  MeasuredValue added;
  const Count count = addedBy(sightings, others, run);
  added.support = count.all, added.hasEnoughOthers = others.size() >= kConfirm;
  if (count.all > 0) added.value = count.some / count.all;
  return added;
}

}  // namespace roomgraph
