#include "roomgraph/compare/compare_runs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/UnionFind.h"
#include "roomgraph/compare/run_measures.h"
#include "roomgraph/compare/site_rooms.h"

namespace roomgraph {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

constexpr std::size_t kWitnesses = 3;  // runs in which the scans of another are tracked
constexpr double kMinShare = 0.3;      // of a run's walls that a witness must have
constexpr double kSameError = 1e-6;    // runs whose errors differ by less share a rank [m]

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

Point middleOf(const MapForAlignment& map) {
  Point sum;
  for (const WallPoint& wall : map.walls) sum = sum + wall.place;
  return map.walls.empty() ? sum : (1.0 / double(map.walls.size())) * sum;
}

/** A set of runs that lie in one frame. */
struct Site {
  std::vector<std::size_t> runs;   ///< ascending
  std::vector<Transform2D> poses;  ///< site <- run
};

bool isJoined(const MapPair& pair, const SitePosesOptions& options) {
  return pair.alignment.isSameSite && pair.alignment.confidence >= options.minConfidence;
}

/** The runs of the site, see compareRuns. */
std::vector<std::size_t> membersOf(std::size_t runs, const Pairs& pairs,
                                   const std::vector<MapPair>& related,
                                   const CompareRunsOptions& options) {
  UnionFind sets(runs);
  for (std::size_t k = 0; k < pairs.size(); ++k)
    if (isJoined(related[k], options.poses))
      sets.join(std::uint32_t(pairs[k].first), std::uint32_t(pairs[k].second));
  std::vector<std::size_t> set;  // of each run the first run it is joined to
  for (std::uint32_t i = 0; i < runs; ++i) set.push_back(sets.find(i));
  std::vector<std::pair<std::size_t, double>> size(runs);  // of each set: runs, then confidence
  for (const std::size_t s : set) ++size[s].first;
  for (std::size_t k = 0; k < pairs.size(); ++k)
    if (isJoined(related[k], options.poses))
      size[set[pairs[k].first]].second += related[k].alignment.confidence;
  const std::size_t chosen =
      options.reference ? set[*options.reference]
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

Site siteOf(const std::vector<PreparedRun>& runs, const Pairs& pairs,
            const std::vector<MapPair>& related, const CompareRunsOptions& options) {
  Site site;
  site.runs = membersOf(runs.size(), pairs, related, options);
  const auto placeOf = [&](std::size_t run) {
    return std::lower_bound(site.runs.begin(), site.runs.end(), run) - site.runs.begin();
  };
  const auto isIn = [&](std::size_t run) {
    return std::binary_search(site.runs.begin(), site.runs.end(), run);
  };
  std::vector<PairPose> used;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [a, b] = pairs[k];
    if (!isJoined(related[k], options.poses) || !isIn(a) || !isIn(b)) continue;
    used.push_back({std::size_t(placeOf(a)), std::size_t(placeOf(b)), related[k].alignment.pose,
                    related[k].alignment.confidence, middleOf(runs[b].map)});
  }
  const std::size_t reference = options.reference ? std::size_t(placeOf(*options.reference))
                                                  : centreOf(site.runs.size(), used);
  for (const SitePose& placed : sitePoses(site.runs.size(), used, reference, options.poses).runs)
    site.poses.push_back(placed.pose);
  return site;
}

PlacedRuns placed(const std::vector<PreparedRun>& runs, const Site& site) {
  PlacedRuns result;
  result.poses = site.poses;
  for (const std::size_t run : site.runs) result.runs.push_back(&runs[run]);
  const std::size_t n = site.runs.size();
  result.distances.assign(n, std::vector<WallDistances>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (i != j)
        result.distances[i][j] = wallDistances(result.runs[i]->map, result.runs[j]->map,
                                               site.poses[j].inverse() * site.poses[i]);
  return result;
}

/** What is known of all pairs of a site, [i][j] with i < j. */
std::vector<std::vector<MapPair>> pairsIn(const PlacedRuns& site, const Site& members,
                                          std::size_t runs, const std::vector<MapPair>& related) {
  const std::size_t n = members.runs.size();
  std::vector<std::vector<MapPair>> pairs(n, std::vector<MapPair>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      pairs[i][j] = related[pairIndex(members.runs[i], members.runs[j], runs)];
      // Bent maps may not have found each other by themselves.
      if (pairs[i][j].bInA.patches.empty())
        follow(pairs[i][j], site.runs[i]->map, site.runs[j]->map,
               {site.poses[i].inverse() * site.poses[j]});
    }
  return pairs;
}

/** The better map of two follows the worse one over a part of it only: so the larger bend counts.
 */
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

void addRuns(Comparison& result, PlacedRuns& site, const std::vector<std::vector<PairBend>>& bends,
             std::optional<std::size_t> reference, const CompareRunsOptions& options) {
  const std::size_t n = site.runs.size();
  std::vector<std::optional<double>> deviations;
  for (const PreparedRun* run : site.runs) deviations.push_back(run->map.axisDeviation);
  const auto scores = scoreRuns(bends, deviations, reference, options.score);
  for (std::size_t i = 0; i < n; ++i) {
    const double trust = scores[i] ? scores[i]->trust : 0;
    site.trust.push_back(reference ? double(i == *reference) : trust);
  }
  const std::vector<Measure> coverage = coverageOf(site), rooms = roomsMatchedOf(site);
  for (std::size_t i = 0; i < n; ++i) {
    ComparedRun run;
    run.name = site.runs[i]->name, run.file = site.runs[i]->file;
    run.pose = site.poses[i];
    run.score = scores[i];
    run.measures = {coverage[i], bendOf(bends, site.trust, i), axisDeviationOf(*site.runs[i])};
    for (const Measure& measure : wallMeasuresOf(site, i)) run.measures.push_back(measure);
    run.measures.push_back(rooms[i]);
    result.runs.push_back(std::move(run));
  }
}

/** What is known of run `of` in run `in`. */
const FollowedWalls& followedIn(const std::vector<std::vector<MapPair>>& pairs, std::size_t of,
                                std::size_t in) {
  return of < in ? pairs[of][in].aInB : pairs[in][of].bInA;
}

/** The runs that tell best where `run` breaks: those that are trusted most. */
std::vector<std::size_t> witnessesOf(std::size_t run, const PlacedRuns& site,
                                     const std::vector<std::vector<MapPair>>& pairs) {
  std::vector<std::size_t> others;
  for (std::size_t j = 0; j < site.runs.size(); ++j)
    if (j != run && followedIn(pairs, run, j).share >= kMinShare) others.push_back(j);
  std::stable_sort(others.begin(), others.end(),
                   [&](std::size_t l, std::size_t r) { return site.trust[l] > site.trust[r]; });
  if (others.size() > kWitnesses) others.resize(kWitnesses);
  // One map alone cannot tell its own breaks from those of a better one.
  if (others.size() == 1 && site.trust[others[0]] < site.trust[run]) return {};
  return others;
}

void addBreaks(Comparison& result, const PlacedRuns& site,
               const std::vector<std::vector<MapPair>>& pairs, const CompareRunsOptions& options) {
  for (std::size_t i = 0; i < site.runs.size(); ++i) {
    const std::vector<ScanWalls>& scans = site.runs[i]->scans;
    if (scans.empty()) continue;
    const std::vector<std::size_t> others = witnessesOf(i, site, pairs);
    std::vector<ScanTrack> tracks;
    for (const std::size_t j : others)
      tracks.push_back(trackScans(scans, site.runs[i]->map.patches, followedIn(pairs, i, j),
                                  site.runs[j]->map, options.trackScans));
    for (const ScanBreak& found : findBreaks(scans, tracks, options.findBreaks)) {
      const std::size_t track = found.seenIn.front();
      const Transform2D inOther = tracks[track][found.scan].value_or(Transform2D{});
      result.breaks.push_back({site.runs[i]->name,
                               site.poses[others[track]](inOther(scans[found.scan].at)),
                               found.rotation, found.shift});
    }
  }
}

/** What speaks against a run, in the order of its weight in the score. */
std::string reasonOf(const ComparedRun& run, const std::vector<MapBreak>& breaks) {
  const RunScore& score = *run.score;
  std::string text = formatted("bends %.2f m away from the %zu other %s", score.bend, score.others,
                               score.others == 1 ? "run" : "runs");
  const auto isOfRun = [&](const MapBreak& found) { return found.run == run.name; };
  if (const auto count = std::count_if(breaks.begin(), breaks.end(), isOfRun))
    text += formatted(", breaks in %ld place%s", long(count), count == 1 ? "" : "s");
  for (const Measure& measure : run.measures)
    if (measure.name == "axis_deviation" && measure.value)
      text += formatted(", walls %.1f degrees off right angles", *measure.value);
  if (!score.isMeaningful) text += "; too little to judge by";
  return text;
}

void addReasons(Comparison& result) {
  for (ComparedRun& run : result.runs)
    run.reason = run.score                      ? reasonOf(run, result.breaks)
                 : result.reference == run.name ? "the others are measured against it"
                                                : "no other run to compare it with";
}

void rank(std::vector<ComparedRun>& runs) {
  const auto key = [](const ComparedRun& run) {
    return std::make_tuple(!run.score, run.score ? run.score->mapError : 0, run.name);
  };
  std::sort(runs.begin(), runs.end(),
            [&](const ComparedRun& l, const ComparedRun& r) { return key(l) < key(r); });
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i].score) continue;
    const bool isSame = i > 0 && runs[i].score->mapError - runs[i - 1].score->mapError < kSameError;
    runs[i].rank = isSame ? runs[i - 1].rank : i + 1;
  }
}

ComparedPair pairOf(const PreparedRun& a, const PreparedRun& b, const Alignment& alignment) {
  ComparedPair pair;
  pair.a = a.name, pair.b = b.name;
  pair.isSameSite = alignment.isSameSite;
  if (alignment.best) pair.transform = alignment.pose;
  pair.confidence = alignment.confidence;
  pair.overlap = alignment.overlap;
  if (alignment.runnerUp) pair.runnerUp = alignment.runnerUp->pose;
  pair.runnerUpConfidence = alignment.runnerUpConfidence;
  return pair;
}

void measurePair(ComparedPair& pair, const PlacedRuns& site, const PairBend& bend, std::size_t i,
                 std::size_t j) {
  Measure apart, followed;
  apart.name = "bend", apart.unit = "m";
  followed.name = "followed";
  apart.support = followed.support = bend.walls;
  if (bend.share > 0) apart.value = bend.bend;
  followed.value = bend.share;
  apart.isMeaningful = followed.isMeaningful = bend.walls >= RunScoreOptions{}.minWalls;
  pair.measures = {apart, followed};
  WallDistances both = site.distances[i][j];
  both.add(site.distances[j][i]);
  Measure mean;
  mean.name = "wall_distance_mean", mean.unit = "m", mean.support = both.count;
  if (both.count > 0) mean.value = both.mean();
  mean.isMeaningful = both.count >= RunScoreOptions{}.minWalls;
  pair.measures.push_back(mean);
  for (const auto& [name, share] :
       {std::make_pair("wall_distance", 0.5), std::make_pair("wall_distance_p90", 0.9)}) {
    Measure measure;
    measure.name = name, measure.unit = "m", measure.support = both.count;
    if (both.count > 0) measure.value = both.quantile(share);
    measure.isMeaningful = both.count >= RunScoreOptions{}.minWalls;
    pair.measures.push_back(measure);
  }
}

void addPairs(Comparison& result, const std::vector<PreparedRun>& runs, const Pairs& pairs,
              const std::vector<MapPair>& related, const Site& site, const PlacedRuns& inSite,
              const std::vector<std::vector<PairBend>>& bends) {
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [a, b] = pairs[k];
    ComparedPair pair = pairOf(runs[a], runs[b], related[k].alignment);
    const auto i = std::lower_bound(site.runs.begin(), site.runs.end(), a);
    const auto j = std::lower_bound(site.runs.begin(), site.runs.end(), b);
    if (i != site.runs.end() && *i == a && j != site.runs.end() && *j == b) {
      const auto inA = std::size_t(i - site.runs.begin()), inB = std::size_t(j - site.runs.begin());
      measurePair(pair, inSite, bends[inA][inB], inA, inB);
    }
    result.pairs.push_back(std::move(pair));
  }
}

std::string verdictOf(const Comparison& result) {
  if (result.runs.size() < 2) return "No two runs are of the same site: nothing can be compared.";
  const ComparedRun &best = result.runs[0], &next = result.runs[1];
  if (!best.score) return "The runs share no walls: nothing can be compared.";
  if (!result.reference && result.runs.size() == 2)
    return formatted("Two runs cannot tell for sure which is better: they bend %.2f m apart.",
                     best.score->bend);
  std::string text =
      best.name + formatted(
                      " is the best map, with score %.1f (%.1f to %.1f) and a map error of "
                      "about %.2f m",
                      best.score->score, best.score->low, best.score->high, best.score->mapError);
  if (next.score && next.score->high >= best.score->low)
    text += "; " + next.name + " may be as good";
  if (!best.score->isMeaningful) text += ", but there is too little to judge by";
  return text + ".";
}

}  // namespace

Comparison compareRuns(const std::vector<PreparedRun>& runs, const std::vector<MapPair>& related,
                       const CompareRunsOptions& options) {
  const Pairs pairs = pairsOf(runs.size());
  if (related.size() != pairs.size())
    throw UsageError("compare_runs: there are " + std::to_string(pairs.size()) + " pairs, but " +
                     std::to_string(related.size()) + " were related");
  if (options.reference && *options.reference >= runs.size())
    throw UsageError("compare_runs: there is no run " + std::to_string(*options.reference));
  Comparison result;
  if (runs.empty()) {
    result.verdict = verdictOf(result);
    return result;
  }
  const Site site = siteOf(runs, pairs, related, options);
  PlacedRuns inSite = placed(runs, site);
  std::optional<std::size_t> reference;
  for (std::size_t i = 0; i < site.runs.size(); ++i)
    if (options.reference == site.runs[i]) reference = i;
  if (reference) result.reference = runs[*options.reference].name;
  const auto inPairs = pairsIn(inSite, site, runs.size(), related);
  const auto bends = bendsOf(inPairs);
  addRuns(result, inSite, bends, reference, options);
  addBreaks(result, inSite, inPairs, options);
  addReasons(result);
  rank(result.runs);
  result.rooms = siteRooms(inSite, result.runs);
  addPairs(result, runs, pairs, related, site, inSite, bends);
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (!std::binary_search(site.runs.begin(), site.runs.end(), i))
      result.leftOut.push_back(
          {runs[i].name, runs[i].file, "does not lie in the same site as the others", true});
  result.verdict = verdictOf(result);
  return result;
}

}  // namespace roomgraph
