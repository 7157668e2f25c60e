#include "drop_lone_bends.h"

#include "fitted_relate.h"
#include "roomgraph/align/FullMaps.h"
#include "roomgraph/base/majority.h"
#include "roomgraph/relate/pair_jobs.h"
#include "roomgraph/relate/place_runs.h"
#include "roomgraph/relate/relate_maps.h"
#include "roomgraph/relate/sight_walls.h"

namespace roomgraph {
namespace {

/** Whether less than half of a bend is told where as much is found. */
bool denies(const FollowedWalls& asked, const FollowedWalls& told) {
  return asked.bend < kMajority * told.bend && asked.share >= fitted::kAsGood * told.share;
}

/** Whether the way back denies the bend of a run in another one, and more of the others do than
 *  bear it out: of the run in them, or of them in the other. A copy of a run does both. */
bool isLone(std::size_t run, std::size_t in, const MapPairs& pairs) {
  const FollowedWalls& told = followedIn(pairs, run, in);
  if (told.bend < 2 * kSameWall || !denies(followedIn(pairs, in, run), told)) return false;
  int votes = 0;
  const auto ask = [&](std::size_t other, std::size_t there) {
    const FollowedWalls& asked = followedIn(pairs, other, there);
    votes += int(denies(asked, told)) - int(asked.bend >= kMajority * told.bend);
  };
  for (const std::size_t other : pairs.othersOf(run))
    if (other != in) ask(run, other);
  for (const std::size_t other : pairs.othersOf(in))
    if (other != run) ask(other, in);
  return votes > 0;
}

}  // namespace

void dropLoneBends(MapPairs& pairs, const std::vector<Transform2D>& poses, const Site& site,
                   const ForEach& forEach) {
  std::vector<PairOfThings> lone;
  std::vector<Transform2D> starts;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const auto [i, j] = pairs.pairs()[k];
    if (site.mapOf(i).hasScans && site.mapOf(j).hasScans) continue;
    if (isLone(i, j, pairs) || isLone(j, i, pairs))
      lone.emplace_back(i, j), starts.push_back(poses[k]);
  }
  const auto jobs = pairJobs(lone, [&](std::size_t i) { return site.mapOf(i).isBare(); });
  forEach(jobs.size(), [&](std::size_t job) {
    FullMaps maps;
    for (const std::size_t k : jobs[job]) {
      const auto [i, j] = lone[k];
      follow(pairs(i, j), maps(site.mapOf(i)), maps(site.mapOf(j)), {starts[k]});
    }
  });
}

}  // namespace roomgraph
