#include "roomgraph/measures/measure_site.h"

#include "graph_measures.h"
#include "map_measures.h"
#include "run_measures.h"

namespace roomgraph {
namespace {

void append(std::vector<Measure>& measures, const std::vector<Measure>& more) {
  measures.insert(measures.end(), more.begin(), more.end());
}

}  // namespace

SiteMeasures measureSite(const Site& site, const MapPairs& pairs, const PairBends& bends,
                         const Trust& trust, const std::vector<std::vector<MapBreak>>& breaks,
                         const ForEach& forEach) {
  const std::size_t n = site.runs.size();
  if (n == 0) return {};
  const DistanceTable distances = distancesOf(site, forEach);
  const ComparedGraphs graphs = comparedGraphs(site, pairs, forEach);
  const std::vector<Measure> coverage = coverageOf(site, bends);
  const std::vector<std::vector<Measure>> rooms = roomMeasuresOf(site, trust, forEach);
  SiteMeasures all{std::vector<std::vector<Measure>>(n), PairTable<std::vector<Measure>>(n)};
  forEach(n, [&](std::size_t i) {
    all.runs[i] = {coverage[i], bendOf(bends, trust, i), axisDeviationOf(*site.runs[i])};
    append(all.runs[i], wallMeasuresOf(distances, trust, i));
    append(all.runs[i], rooms[i]);
    append(all.runs[i], graphMeasuresOf(graphs, trust, i));
    all.runs[i].push_back(brokennessOf(site, pairs, trust, i, breaks[i].size()));
    append(all.runs[i], ownMeasuresOf(*site.runs[i]));
  });
  for (const auto& [i, j] : pairs.pairs()) {
    all.pairs(i, j) = wallMeasuresOfPair(bends(i, j), distances, i, j);
    append(all.pairs(i, j), graphMeasuresOfPair(graphs(i, j)));
  }
  return all;
}

}  // namespace roomgraph
