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

/** Whether the way back denies the bend of a run in another one, and neither of the two is the
 *  cause: more of the others in which the run is looked for deny it than bear it out, and no fewer
 *  of those that are looked for in the other one. */
bool isLone(std::size_t run, std::size_t in, const MapPairs& pairs) {
  const FollowedWalls& told = followedIn(pairs, run, in);
  if (told.bend < kSameWhereBent || !denies(followedIn(pairs, in, run), told)) return false;
  const auto vote = [&](const FollowedWalls& asked) {
    return int(denies(asked, told)) - int(asked.bend >= kMajority * told.bend);
  };
  int ofRun = 0, ofOther = 0;
  for (const std::size_t third : pairs.othersOf(run))
    if (third != in) ofRun += vote(followedIn(pairs, run, third));
  for (const std::size_t third : pairs.othersOf(in))
    if (third != run) ofOther += vote(followedIn(pairs, third, in));
  return ofRun > 0 && ofOther >= 0;
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
  visitPairs(site, lone, forEach, [&](std::size_t k, FullMaps& maps) {
    const auto [i, j] = lone[k];
    follow(pairs(i, j), maps(site.mapOf(i)), maps(site.mapOf(j)), {starts[k]});
  });
}

}  // namespace roomgraph
