#include "match_runs.h"

#include <algorithm>
#include <map>
#include <utility>

#include "roomgraph/align/FullMaps.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/consensus/match_submaps.h"
#include "roomgraph/relate/pair_jobs.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {
namespace {

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

/** Who drew what of the maps of some runs; of bare ones only as long as this lives. */
class DrawnMaps {
 public:
  /** `known` is said of each place in `order`: nothing for bare maps. */
  DrawnMaps(const Site& site, const std::vector<std::size_t>& order,
            const std::vector<RunSubmaps>& submaps, const std::vector<DrawnBy>& known)
      : site_(site), order_(order), submaps_(submaps), known_(known) {}

  DrawnMap operator()(std::size_t place) {
    const WallMap& map = site_.mapOf(order_[place]);
    if (!map.isBare()) return {map, submaps_[place], known_[place]};
    const WallMap& full = maps_(map);
    const auto [made, isNew] = made_.try_emplace(place);
    if (isNew) made->second = drawnBy(*site_.runs[order_[place]], full);
    return {full, submaps_[place], made->second};
  }

 private:
  const Site& site_;
  const std::vector<std::size_t>& order_;
  const std::vector<RunSubmaps>& submaps_;
  const std::vector<DrawnBy>& known_;
  FullMaps maps_;
  std::map<std::size_t, DrawnBy> made_;
};

/** The places in `order` of each two runs that were related, both ways. */
std::vector<PairOfThings> relatedPlaces(const MapPairs& pairs,
                                        const std::vector<std::size_t>& order) {
  std::vector<PairOfThings> related;
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = 0; b < order.size(); ++b)
      if (a != b && pairs.has(order[a], order[b])) related.emplace_back(a, b);
  return related;
}

}  // namespace

std::vector<RunMatches> matchRuns(const Site& site, const MapPairs& pairs,
                                  const std::vector<std::size_t>& order,
                                  const std::vector<RunSubmaps>& submaps, const ForEach& forEach) {
  std::vector<std::vector<Transform2D>> wholes;  // site <- run
  for (const std::size_t run : order) wholes.push_back(wholesOf(site, pairs, run));
  const auto isBare = [&](std::size_t a) { return site.mapOf(order[a]).isBare(); };
  std::vector<DrawnBy> known(order.size());
  forEach(order.size(), [&](std::size_t a) {
    if (!isBare(a)) known[a] = drawnBy(*site.runs[order[a]], site.mapOf(order[a]));
  });
  const auto matched = [&](std::size_t a, std::size_t b, DrawnMaps& maps) {
    const std::size_t i = order[a], j = order[b];
    std::vector<Transform2D> wholesInJ;
    for (const Transform2D& whole : wholes[a]) wholesInJ.push_back(site.poses[j].inverse() * whole);
    auto pieces =
        matchSubmaps(*site.runs[i], submaps[a], maps(b), followedIn(pairs, i, j), wholesInJ);
    if (a < b) pieces.push_back({sameScans(*site.runs[i], *site.runs[j]), 0});
    return pieces;
  };
  const std::vector<PairOfThings> related = relatedPlaces(pairs, order);
  const auto jobs = pairJobs(related, isBare);
  std::vector<std::vector<MatchedPiece>> found(related.size());
  forEach(jobs.size(), [&](std::size_t job) {
    DrawnMaps maps(site, order, submaps, known);
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

}  // namespace roomgraph
