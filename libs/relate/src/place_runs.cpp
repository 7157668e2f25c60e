#include "roomgraph/relate/place_runs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "roomgraph/base/UnionFind.h"

namespace roomgraph {
namespace {

Point middleOf(const MapForAlignment& map) {
  Point sum;
  for (const WallPoint& wall : map.walls) sum = sum + wall.place;
  return map.walls.empty() ? sum : (1.0 / double(map.walls.size())) * sum;
}

constexpr double kJoined = 0.5;

/** Of a symmetric building, no run is sure to lie in the right turn, but each lies in one of few.
 */
bool isJoined(const MapPair& pair, const SitePosesOptions& options) {
  const Alignment& alignment = pair.alignment;
  return alignment.isSameSite && alignment.confidence >= options.minConfidence &&
         alignment.confidence + alignment.runnerUpConfidence >= kJoined;
}

/** The runs of the site, see compareRuns. */
std::vector<std::size_t> membersOf(std::size_t runs, const Pairs& pairs,
                                   const std::vector<MapPair>& related,
                                   const SitePosesOptions& options,
                                   std::optional<std::size_t> reference) {
  UnionFind sets(runs);
  for (std::size_t k = 0; k < pairs.size(); ++k)
    if (isJoined(related[k], options))
      sets.join(std::uint32_t(pairs[k].first), std::uint32_t(pairs[k].second));
  std::vector<std::size_t> set;  // of each run the first run it is joined to
  for (std::uint32_t i = 0; i < runs; ++i) set.push_back(sets.find(i));
  std::vector<std::pair<std::size_t, double>> size(runs);  // of each set: runs, then confidence
  for (const std::size_t s : set) ++size[s].first;
  for (std::size_t k = 0; k < pairs.size(); ++k)
    if (isJoined(related[k], options))
      size[set[pairs[k].first]].second += related[k].alignment.confidence;
  const std::size_t chosen =
      reference ? set[*reference]
                : std::size_t(std::max_element(size.begin(), size.end()) - size.begin());
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < runs; ++i)
    if (set[i] == chosen) members.push_back(i);
  return members;
}

/** The run of a site that the others fit best. */
std::size_t centreOf(std::size_t runs, const std::vector<PairPose>& pairs) {
  std::vector<double> sum(runs);
  for (const PairPose& pair : pairs) sum[pair.a] += pair.confidence, sum[pair.b] += pair.confidence;
  return std::size_t(std::max_element(sum.begin(), sum.end()) - sum.begin());
}

constexpr double kOtherTurn = 0.45, kOtherPlace = 6;  // more than maps bend [rad, m]
constexpr double kAsGood = 0.8;  // of the walls found, to believe the site and not the pair

/** Whether a pair lies otherwise in itself than in the site: in a symmetric building it may have
 *  found another turn than the rest, and bent maps may not have found each other at all. */
bool contradicts(const MapPair& pair, const Transform2D& inSite, Point middleOfB) {
  if (pair.bInA.patches.empty()) return true;
  const Transform2D& own = pair.bInA.pose;
  return std::abs(wrappedAngle(own.phi - inSite.phi)) > kOtherTurn ||
         distance(own(middleOfB), inSite(middleOfB)) > kOtherPlace;
}

double sharedOf(const MapPair& pair) { return std::min(pair.bInA.share, pair.aInB.share); }

}  // namespace

Site siteOf(const std::vector<PreparedRun>& runs, const Pairs& pairs,
            const std::vector<MapPair>& related, const SitePosesOptions& options,
            std::optional<std::size_t> reference) {
  Site site;
  site.runs = membersOf(runs.size(), pairs, related, options, reference);
  const auto placeOf = [&](std::size_t run) {
    return std::lower_bound(site.runs.begin(), site.runs.end(), run) - site.runs.begin();
  };
  const auto isIn = [&](std::size_t run) {
    return std::binary_search(site.runs.begin(), site.runs.end(), run);
  };
  std::vector<PairPose> used;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [a, b] = pairs[k];
    if (!isJoined(related[k], options) || !isIn(a) || !isIn(b)) continue;
    used.push_back({std::size_t(placeOf(a)), std::size_t(placeOf(b)), related[k].alignment.pose,
                    related[k].alignment.confidence, middleOf(runs[b].map)});
  }
  const std::size_t centre =
      reference ? std::size_t(placeOf(*reference)) : centreOf(site.runs.size(), used);
  for (const SitePose& placed : sitePoses(site.runs.size(), used, centre, options).runs)
    site.poses.push_back(placed.pose);
  return site;
}

PlacedRuns placed(const std::vector<PreparedRun>& runs, const Site& site, const ForEach& forEach) {
  PlacedRuns result;
  result.poses = site.poses;
  for (const std::size_t run : site.runs) result.runs.push_back(&runs[run]);
  const std::size_t n = site.runs.size();
  result.distances.assign(n, std::vector<WallDistances>(n));
  forEach(n, [&](std::size_t i) {
    for (std::size_t j = 0; j < n; ++j)
      if (i != j)
        result.distances[i][j] = wallDistances(result.runs[i]->map, result.runs[j]->map,
                                               site.poses[j].inverse() * site.poses[i]);
  });
  return result;
}

std::vector<std::vector<MapPair>> pairsIn(const PlacedRuns& site, const Site& members,
                                          std::size_t runs, const std::vector<MapPair>& related,
                                          const ForEach& forEach) {
  const std::size_t n = members.runs.size();
  std::vector<std::vector<MapPair>> pairs(n, std::vector<MapPair>(n));
  forEach(n, [&](std::size_t i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const MapForAlignment &a = site.runs[i]->map, &b = site.runs[j]->map;
      const Transform2D inSite = site.poses[i].inverse() * site.poses[j];
      MapPair& pair = pairs[i][j];
      pair = related[pairIndex(members.runs[i], members.runs[j], runs)];
      if (!contradicts(pair, inSite, middleOf(b))) continue;
      MapPair again = pair;
      follow(again, a, b, {inSite});
      if (sharedOf(again) >= kAsGood * sharedOf(pair)) pair = std::move(again);
    }
  });
  return pairs;
}

const FollowedWalls& followedIn(const std::vector<std::vector<MapPair>>& pairs, std::size_t of,
                                std::size_t in) {
  return of < in ? pairs[of][in].aInB : pairs[in][of].bInA;
}

std::vector<std::vector<PairBend>> bendsOf(const std::vector<std::vector<MapPair>>& pairs) {
  const std::size_t n = pairs.size();
  std::vector<std::vector<PairBend>> bends(n, std::vector<PairBend>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const MapPair& pair = pairs[i][j];
      double walls = 0;
      for (const FollowedWalls* way : {&pair.bInA, &pair.aInB})
        for (const FollowedPatch& patch : way->patches) walls += patch.walls;
      bends[i][j] = {std::max(pair.bInA.bend, pair.aInB.bend),
                     std::min(pair.bInA.share, pair.aInB.share), walls, pair.areIdentical};
      bends[j][i] = bends[i][j];
    }
  return bends;
}

}  // namespace roomgraph
