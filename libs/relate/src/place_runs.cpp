#include "roomgraph/relate/place_runs.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "fitted_relate.h"
#include "roomgraph/align/FullMaps.h"
#include "roomgraph/align/alignment_confidence.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/UnionFind.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/relate/pair_jobs.h"
#include "roomgraph/relate/relate_maps.h"

namespace roomgraph {
namespace {

Point middleOfWalls(const WallMap& map) {
  Point sum;
  for (const WallPoint& wall : map.walls) sum = sum + wall.place;
  return map.walls.empty() ? sum : (1.0 / double(map.walls.size())) * sum;
}

class JoinedPairs {
 public:
  explicit JoinedPairs(const MapPairs& related) : related_(related) {}

  /** A pair that is not sure joins them only if third runs do not speak against it: one that surely
   *  lies in one of both, and of which the other is the mirror image, or another storey. A bent map
   *  lies in many by chance. */
  bool operator()(std::size_t a, std::size_t b) const {
    const MapPair& pair = related_(a, b);
    if (!isJoined(pair)) return false;
    if (pair.alignment.confidence >= kSureConfidence) return true;
    int votes = 0;
    for (const std::size_t third : related_.othersOf(a)) {
      if (third == b || !related_.has(third, b)) continue;
      const bool inA = isSure(a, third), inB = isSure(b, third);
      votes += int(inA && inB);
      votes -= int((inA && isStranger(b, third)) || (inB && isStranger(a, third)));
    }
    return votes >= 0;
  }

 private:
  bool isSure(std::size_t a, std::size_t b) const {
    return isJoined(related_(a, b)) && related_(a, b).alignment.confidence >= kSureConfidence;
  }
  bool isStranger(std::size_t a, std::size_t b) const {
    return related_(a, b).alignment.isMirrored || related_(a, b).areStoreys;
  }

  const MapPairs& related_;
};

/** The runs in sets of those that are joined, that of the site first; see placeRuns. */
std::vector<std::vector<std::size_t>> sitesIn(const MapPairs& related, const JoinedPairs& areJoined,
                                              std::optional<std::size_t> reference) {
  const std::size_t runs = related.things();
  UnionFind sets(runs);
  for (const auto& [a, b] : related.pairs())
    if (areJoined(a, b)) sets.join(a, b);
  std::vector<std::vector<std::size_t>> sites = sets.sets();
  std::vector<double> confidence(runs);
  for (const auto& [a, b] : related.pairs())
    if (areJoined(a, b)) confidence[sets.find(a)] += related(a, b).alignment.confidence;
  const auto rank = [&](const std::vector<std::size_t>& site) {
    const bool hasReference = reference && sets.find(*reference) == site.front();
    return std::make_tuple(hasReference, site.size(), confidence[site.front()]);
  };
  sortDownBy(sites, rank);
  return sites;
}

/** The run of a site that the others fit best. */
std::size_t centreOf(const PairPoses& pairs) {
  std::vector<double> sum(pairs.things());
  for (const auto& [a, b] : pairs.pairs())
    for (const std::size_t run : {a, b}) sum[run] += pairs(a, b).confidence;
  return std::size_t(std::max_element(sum.begin(), sum.end()) - sum.begin());
}

/** Whether the pose that a pair has found is not the one that the site gives it: in a symmetric
 *  building it may be another turn than that of the rest, and bent maps may have found none. */
bool contradicts(const MapPair& pair, const Transform2D& inSite, Point middleOfB) {
  return pair.bInA.patches.empty() || !areNear(pair.bInA.pose, inSite, middleOfB, kAsMapsBend);
}

double sharedOf(const MapPair& pair) { return std::min(pair.bInA.share, pair.aInB.share); }

/** The pairs that were related of which both are in a site, by their places there. */
std::vector<PairOfThings> pairsWithin(const Site& site, const MapPairs& related) {
  std::vector<std::size_t> places(related.things(), site.members.size());
  for (std::size_t i = 0; i < site.members.size(); ++i) places[site.members[i]] = i;
  std::vector<PairOfThings> within;
  for (const auto& [a, b] : related.pairs())
    if (places[a] < site.members.size() && places[b] < site.members.size())
      within.emplace_back(places[a], places[b]);
  return within;
}

/** Whether a run is one of those among which the consensus is worked out. */
bool isOfCore(const MapPairs& related, std::size_t run) {
  return related.core.empty() || std::binary_search(related.core.begin(), related.core.end(), run);
}

void completeCore(Site& site, const MapPairs& related) {
  std::vector<const WallMap*> core;
  for (std::size_t i = 0; i < site.runs.size(); ++i)
    if (isOfCore(related, site.members[i])) core.push_back(&site.runs[i]->map);
  site.fullMaps.complete(core, oneByOne);
}

/** See PairBend::agreement: in doubt are two runs alone, as dropLoneBends asks all others, unless
 *  the way that tells less follows less, too, as a sound map follows one part of a torn one. */
double agreementOf(const MapPair& pair, std::size_t runs) {
  if (runs > 2) return 1;
  const bool isLessBack = pair.aInB.bend <= pair.bInA.bend;
  const FollowedWalls& less = isLessBack ? pair.aInB : pair.bInA;
  const FollowedWalls& more = isLessBack ? pair.bInA : pair.aInB;
  return less.share >= fitted::kAsGood * more.share && more.bend > 0 ? less.bend / more.bend : 1;
}

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

bool isJoined(const MapPair& pair) {
  const Alignment& alignment = pair.alignment;
  return alignment.isSameSite && alignment.confidence >= kMinPairConfidence &&
         alignment.confidence + alignment.runnerUpConfidence >= kMajority;
}

Site placeRuns(const std::vector<Run>& runs, const MapPairs& related,
               std::optional<std::size_t> reference) {
  Site site;
  if (runs.empty()) return site;
  const JoinedPairs areJoined(related);
  auto sites = sitesIn(related, areJoined, reference);
  site.members = std::move(sites.front());
  for (std::size_t i = 1; i < sites.size() && sites[i].size() > 1; ++i)
    site.others.push_back(std::move(sites[i]));
  const std::size_t n = site.members.size();
  for (std::size_t i = 0; i < n; ++i) {
    site.runs.push_back(&runs[site.members[i]]);
    if (reference == site.members[i]) site.reference = i;
  }
  completeCore(site, related);
  std::vector<PairOfThings> joined;
  for (const auto& [i, j] : pairsWithin(site, related))
    if (areJoined(site.members[i], site.members[j])) joined.emplace_back(i, j);
  PairPoses pairs(n, joined);
  for (const auto& [i, j] : joined) {
    const Alignment& alignment = related(site.members[i], site.members[j]).alignment;
    pairs(i, j) = {alignment.pose, alignment.confidence, middleOfWalls(site.runs[j]->map)};
  }
  site.poses = sitePoses(pairs, site.reference.value_or(centreOf(pairs)));
  return site;
}

MapPairs pairsInSite(const Site& site, const MapPairs& related, const ForEach& forEach) {
  MapPairs pairs(site.runs.size(), pairsWithin(site, related));
  for (std::size_t i = 0; i < site.members.size(); ++i)
    if (!related.core.empty() && isOfCore(related, site.members[i])) pairs.core.push_back(i);
  const std::vector<PairOfThings>& all = pairs.pairs();
  std::vector<Transform2D> poses(all.size());  // that they were followed from
  visitPairs(site, all, forEach, [&](std::size_t k, FullMaps& maps) {
    const auto [i, j] = all[k];
    const Transform2D inSite = site.poses[i].inverse() * site.poses[j];
    MapPair& pair = pairs(i, j);
    pair = related(site.members[i], site.members[j]);
    poses[k] = pair.alignment.pose;
    // Scans tell for themselves of which drive they are, and weigh accordingly.
    if (!site.runs[i]->scans.empty() && !site.runs[j]->scans.empty()) pair.areEdits = false;
    if (!contradicts(pair, inSite, middleOfWalls(site.mapOf(j)))) return;
    MapPair again = pair;
    follow(again, maps(site.mapOf(i)), maps(site.mapOf(j)), {inSite});
    if (sharedOf(again) >= fitted::kAsGood * sharedOf(pair))
      pair = std::move(again), poses[k] = inSite;
  });
  dropLoneBends(pairs, poses, site, forEach);
  return pairs;
}

const FollowedWalls& followedIn(const MapPairs& pairs, std::size_t of, std::size_t in) {
  return of < in ? pairs(of, in).aInB : pairs(in, of).bInA;
}

std::size_t countSure(const MapPairs& pairs, std::size_t run) {
  const std::vector<std::size_t>& others = pairs.othersOf(run);
  return countIf(others, [&](std::size_t other) {
    return pairs(run, other).alignment.confidence >= kSureConfidence;
  });
}

PairBends bendsOf(const MapPairs& pairs) {
  PairBends bends(pairs.things(), pairs.pairs());
  for (const auto& [i, j] : pairs.pairs()) {
    const MapPair& pair = pairs(i, j);
    double walls = 0;
    for (const FollowedWalls* way : {&pair.bInA, &pair.aInB})
      for (const FollowedPatch& patch : way->patches) walls += patch.walls;
    bends(i, j) = {std::max(pair.bInA.bend, pair.aInB.bend),
                   std::min(pair.bInA.share, pair.aInB.share),
                   walls,
                   pair.areIdentical,
                   pair.areEdits,
                   std::max(pair.bInA.misfit, pair.aInB.misfit),
                   agreementOf(pair, pairs.things())};
  }
  return bends;
}

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
