#include "roomgraph/compare/compare_runs.h"

#include <algorithm>
#include <tuple>

#include "add_breaks.h"
#include "add_measures.h"
#include "explain_comparison.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/ledger/site_rooms.h"
#include "roomgraph/measures/run_measures.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {
namespace {

constexpr double kSameError = 1e-6;  // runs whose errors differ by less share a rank [m]

void addRuns(Comparison& result, PlacedRuns& site, const std::vector<std::vector<PairBend>>& bends,
             std::optional<std::size_t> reference, const CompareRunsOptions& options) {
  const std::size_t n = site.runs.size();
  std::vector<OwnEvidence> own;
  for (const PreparedRun* run : site.runs) own.push_back({run->map.axisDeviation, run->noiseFloor});
  const auto scores = scoreRuns(bends, own, reference, options.score);
  for (std::size_t i = 0; i < n; ++i) {
    const double trust = scores[i] ? scores[i]->trust : 0;
    site.trust.push_back(reference ? double(i == *reference) : trust);
  }
  const std::vector<Measure> coverage = coverageOf(site, bends);
  const std::vector<std::vector<Measure>> rooms = roomMeasuresOf(site, options.forEach);
  for (std::size_t i = 0; i < n; ++i) {
    ComparedRun run;
    run.name = site.runs[i]->name, run.file = site.runs[i]->file;
    run.pose = site.poses[i];
    run.resolution = site.runs[i]->resolution;
    run.isScaleEstimated = site.runs[i]->isScaleEstimated;
    run.score = scores[i];
    run.measures = {coverage[i], bendOf(bends, site.trust, i), axisDeviationOf(*site.runs[i])};
    for (const Measure& measure : wallMeasuresOf(site, i)) run.measures.push_back(measure);
    for (const Measure& measure : rooms[i]) run.measures.push_back(measure);
    result.runs.push_back(std::move(run));
  }
}

void rank(std::vector<ComparedRun>& runs) {
  const auto key = [](const ComparedRun& run) {
    const bool isMeaningful = run.score && run.score->isMeaningful;
    return std::make_tuple(!run.score, !isMeaningful, run.score ? run.score->mapError : 0,
                           run.name);
  };
  std::sort(runs.begin(), runs.end(),
            [&](const ComparedRun& l, const ComparedRun& r) { return key(l) < key(r); });
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i].score) continue;
    const bool isSame = i > 0 && runs[i].score->isMeaningful == runs[i - 1].score->isMeaningful &&
                        runs[i].score->mapError - runs[i - 1].score->mapError < kSameError;
    runs[i].rank = isSame ? runs[i - 1].rank : i + 1;
  }
}

std::vector<std::string> namesOf(const std::vector<ComparedRun>& runs) {
  std::vector<std::string> names;
  for (const ComparedRun& run : runs) names.push_back(run.name);
  return names;
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
  const Site site = siteOf(runs, pairs, related, options.poses, options.reference);
  PlacedRuns inSite = placed(runs, site, options.forEach);
  std::optional<std::size_t> reference;
  for (std::size_t i = 0; i < site.runs.size(); ++i)
    if (options.reference == site.runs[i]) reference = i;
  if (reference) result.reference = runs[*options.reference].name;
  const auto inPairs = pairsIn(inSite, site, runs.size(), related, options.forEach);
  const auto bends = bendsOf(inPairs);
  addRuns(result, inSite, bends, reference, options);
  addBreaks(result, inSite, inPairs, options);
  addReasons(result);
  rank(result.runs);
  result.rooms = siteRooms(inSite, namesOf(result.runs), options.forEach);
  addPairs(result, runs, pairs, related, site, inSite, bends);
  addMeasures(result, inSite, inPairs, options.forEach);
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (!std::binary_search(site.runs.begin(), site.runs.end(), i))
      result.leftOut.push_back(
          {runs[i].name, runs[i].file, "does not lie in the same site as the others", true});
  result.verdict = verdictOf(result);
  return result;
}

}  // namespace roomgraph
