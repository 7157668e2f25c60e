#include "match_runs.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "roomgraph/align/FullMaps.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/relate/pair_jobs.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {
namespace {

/** Where a run may lie in the site as a whole, site <- run, the likeliest first: as it does, and
 *  where the search for its pairs found that it fits as well. A stretch of it may lie there. */
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
  for (std::size_t rank = 0; rank < most; ++rank)  // up to a dozen: each costs a look at each scan
    for (const std::vector<Transform2D>& poses : byPair) {
      if (rank >= poses.size() || wholes.size() >= 12) continue;
      if (!isNearAny(wholes, poses[rank], middle, kRoughly)) wholes.push_back(poses[rank]);
    }
  return wholes;
}

/** Who drew what of the maps of some runs; of bare ones only as long as this lives. */
class DrawnMaps {
 public:
  /** `known` is said of each run of the graph: nothing for bare maps. */
  DrawnMaps(const Site& site, const PoseGraph& graph, const ById<RunId, std::size_t>& siteRuns,
            const ById<RunId, DrawnBy>& known)
      : site_(site), graph_(graph), siteRuns_(siteRuns), known_(known) {}

  DrawnMap operator()(RunId run) {
    const WallMap& map = site_.mapOf(siteRuns_[run]);
    if (!map.isBare()) return {run, map, known_[run]};
    const WallMap& full = maps_(map);
    const auto [made, isNew] = made_.try_emplace(run);
    if (isNew) made->second = drawnBy(*site_.runs[siteRuns_[run]], graph_.runs[run].nodes, full);
    return {run, full, made->second};
  }

 private:
  const Site& site_;
  const PoseGraph& graph_;
  const ById<RunId, std::size_t>& siteRuns_;
  const ById<RunId, DrawnBy>& known_;
  FullMaps maps_;
  std::map<RunId, DrawnBy> made_;
};

/** The runs of the graph that were related, by their indices, both ways. */
std::vector<PairOfThings> relatedRuns(const MapPairs& pairs,
                                      const ById<RunId, std::size_t>& siteRuns) {
  std::vector<PairOfThings> related;
  for (const RunId a : siteRuns.ids())
    for (const RunId b : siteRuns.ids())
      if (a != b && pairs.has(siteRuns[a], siteRuns[b])) related.emplace_back(a.index(), b.index());
  return related;
}

/** What is found of one run in what another has drawn. */
using MatchedIn = std::function<std::vector<FoundGroup>(RunId, const DrawnMap&)>;

std::vector<FoundGroup> matchRelated(const Site& site, const MapPairs& pairs,
                                     const PoseGraph& graph,
                                     const ById<RunId, std::size_t>& siteRuns,
                                     const MatchedIn& matchedIn, const ForEach& forEach) {
  const auto isBare = [&](std::size_t run) { return site.mapOf(siteRuns[RunId(run)]).isBare(); };
  ById<RunId, DrawnBy> known(siteRuns.size());
  forEach(siteRuns.size(), [&](std::size_t index) {
    const RunId run(index);
    const std::size_t i = siteRuns[run];
    if (!isBare(index)) known[run] = drawnBy(*site.runs[i], graph.runs[run].nodes, site.mapOf(i));
  });
  const std::vector<PairOfThings> related = relatedRuns(pairs, siteRuns);
  const auto jobs = pairJobs(related, isBare);
  std::vector<std::vector<FoundGroup>> found(related.size());
  forEach(jobs.size(), [&](std::size_t job) {
    DrawnMaps maps(site, graph, siteRuns, known);
    for (const std::size_t k : jobs[job])
      found[k] = matchedIn(RunId(related[k].first), maps(RunId(related[k].second)));
  });
  std::vector<FoundGroup> all;
  for (std::vector<FoundGroup>& groups : found)
    for (FoundGroup& group : groups) all.push_back(std::move(group));
  return all;
}

}  // namespace

std::vector<FoundGroup> matchRuns(const Site& site, const MapPairs& pairs, const PoseGraph& graph,
                                  const ById<RunId, std::size_t>& siteRuns,
                                  const ForEach& forEach) {
  ById<RunId, std::vector<Transform2D>> wholes;  // site <- run
  for (const std::size_t run : siteRuns) wholes.add(wholesOf(site, pairs, run));
  const auto matched = [&](RunId a, const DrawnMap& drawn) {
    const RunId b = drawn.run;
    const std::size_t i = siteRuns[a], j = siteRuns[b];
    std::vector<Transform2D> there;
    for (const Transform2D& whole : wholes[a]) there.push_back(site.poses[j].inverse() * whole);
    auto groups = matchNodes(graph, a, *site.runs[i], drawn, followedIn(pairs, i, j), there);
    if (b < a) return groups;
    FoundGroup same = sameScans(graph, a, *site.runs[i], b, *site.runs[j]);
    if (!same.matches.empty()) groups.push_back(std::move(same));
    return groups;
  };
  return matchRelated(site, pairs, graph, siteRuns, matched, forEach);
}

std::vector<FoundGroup> matchRunsAgain(const Site& site, const MapPairs& pairs,
                                       const Consensus& consensus, const ForEach& forEach) {
  const PoseGraph& graph = consensus.graph;
  const auto matched = [&](RunId run, const DrawnMap& drawn) {
    return matchAgain(graph, run, *site.runs[consensus.siteRuns[run]], drawn, consensus.poses);
  };
  return matchRelated(site, pairs, graph, consensus.siteRuns, matched, forEach);
}

}  // namespace roomgraph
