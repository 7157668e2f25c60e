#include "roomgraph/compare/relate_runs.h"

#include <algorithm>
#include <cmath>

namespace roomgraph {

std::vector<std::pair<std::size_t, std::size_t>> pairsOf(std::size_t runs) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t a = 0; a < runs; ++a)
    for (std::size_t b = a + 1; b < runs; ++b) pairs.emplace_back(a, b);
  return pairs;
}

std::size_t pairIndex(std::size_t a, std::size_t b, std::size_t runs) {
  return a * runs - a * (a + 1) / 2 + b - a - 1;
}

std::size_t hubOf(const std::vector<PreparedRun>& runs) {
  double largest = 0, least = HUGE_VAL;
  for (const PreparedRun& run : runs) largest = std::max(largest, run.map.freeArea);
  std::size_t hub = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const double deviation = runs[i].map.axisDeviation.value_or(M_PI);
    if (runs[i].map.freeArea < largest / 2 || deviation >= least) continue;
    least = deviation, hub = i;
  }
  return hub;
}

std::vector<MapPair> relateRuns(const std::vector<PreparedRun>& runs, bool areAligned,
                                const ForEach& forEach) {
  const auto pairs = pairsOf(runs.size());
  std::vector<MapPair> related(pairs.size());
  const auto mapOf = [&](std::size_t run) -> const MapForAlignment& { return runs[run].map; };
  const std::size_t hub = hubOf(runs);
  std::vector<std::size_t> withHub, others;
  for (std::size_t k = 0; k < pairs.size(); ++k)
    (pairs[k].first == hub || pairs[k].second == hub ? withHub : others).push_back(k);
  forEach(withHub.size(), [&](std::size_t i) {
    const auto [a, b] = pairs[withHub[i]];
    related[withHub[i]] =
        areAligned ? relateAlignedMaps(mapOf(a), mapOf(b)) : relateMaps(mapOf(a), mapOf(b));
  });
  const auto hubAnd = [&](std::size_t run) {
    return hub < run ? related[pairIndex(hub, run, runs.size())]
                     : swapped(related[pairIndex(run, hub, runs.size())]);
  };
  forEach(others.size(), [&](std::size_t i) {
    const auto [a, b] = pairs[others[i]];
    related[others[i]] = areAligned ? relateAlignedMaps(mapOf(a), mapOf(b))
                                    : relateMapsOver(hubAnd(a), hubAnd(b), mapOf(a), mapOf(b));
  });
  return related;
}

}  // namespace roomgraph
