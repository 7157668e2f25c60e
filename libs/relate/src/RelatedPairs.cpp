#include "RelatedPairs.h"

#include <algorithm>
#include <utility>

#include "roomgraph/relate/pair_jobs.h"

namespace roomgraph {

RelatedPairs::RelatedPairs(const std::vector<Run>& runs, const RelateRunsOptions& options,
                           const ForEach& forEach, const KeptPairs& kept)
    : runs_(runs),
      areAligned_(options.areAligned),
      areOneSite_(options.areOneSite),
      forEach_(forEach) {
  const RelatePair relate = [this](const PairOver& pair, FullMaps& maps) {
    return related(pair, maps);
  };
  relate_ = keepPairs(relate, runs,
                      areAligned_   ? "aligned"
                      : areOneSite_ ? "one site"
                                    : "searched",
                      kept);
}

void RelatedPairs::complete(const std::vector<std::size_t>& runs) {
  std::vector<const WallMap*> maps;
  for (const std::size_t run : runs) maps.push_back(&runs_[run].map);
  full_.complete(maps, forEach_);
}

void RelatedPairs::search(std::size_t hub, const std::vector<std::size_t>& others) {
  std::vector<PairOver> pairs;
  for (const std::size_t other : others) pairs.push_back({hub, hub, other});
  relate(pairs);
}

void RelatedPairs::relate(std::vector<PairOver> pairs) {
  for (PairOver& pair : pairs) {
    if (pair.a > pair.b) std::swap(pair.a, pair.b);
    if (areAligned_) pair.hub = pair.a;
  }
  const auto isKnown = [&](const PairOver& pair) {
    return pair.a == pair.b || !found_.try_emplace({pair.a, pair.b}).second;
  };
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), isKnown), pairs.end());
  std::vector<PairOfThings> runs;
  for (const PairOver& pair : pairs) runs.emplace_back(pair.a, pair.b);
  const auto jobs = pairJobs(runs, [&](std::size_t run) { return mapOf(run).isBare(); });
  forEach_(jobs.size(), [&](std::size_t job) {
    FullMaps maps;
    for (const std::size_t i : jobs[job]) found_.at(runs[i]) = relate_(pairs[i], maps);
  });
}

MapPair RelatedPairs::between(std::size_t hub, std::size_t run) const {
  return hub < run ? found_.at({hub, run}) : swapped(found_.at({run, hub}));
}

MapPairs RelatedPairs::all() {
  std::vector<PairOfThings> pairs;
  for (const auto& [runs, pair] : found_) pairs.push_back(runs);
  MapPairs all(runs_.size(), pairs);
  for (auto& [runs, pair] : found_) all(runs.first, runs.second) = std::move(pair);
  return all;
}

MapPair RelatedPairs::related(const PairOver& pair, FullMaps& maps) const {
  const WallMap& a = maps(mapOf(pair.a));
  const WallMap& b = maps(mapOf(pair.b));
  if (areAligned_) return relateAlignedMaps(a, b);
  if (pair.hub == pair.a || pair.hub == pair.b) return relateMaps(a, b, areOneSite_);
  return relateMapsOver(between(pair.hub, pair.a), between(pair.hub, pair.b), a, b);
}

}  // namespace roomgraph
