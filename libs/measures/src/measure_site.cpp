#include "roomgraph/measures/measure_site.h"

#include "measure_table.h"

namespace roomgraph {
namespace {

Measure measureOf(const MeasureKind& kind, const MeasuredValue& measured) {
  Measure measure{
      kind.name,     measured.value,       kind.unit,     measured.support, measured.low,
      measured.high, /*meaningful*/ false, measured.place};
  measure.isMeaningful = measured.value && measured.hasEnoughOthers &&
                         measured.support * measured.worth >= kind.leastSupport;
  return measure;
}

}  // namespace

SiteMeasures measureSite(const Site& site, const MapPairs& pairs, const PairBends& bends,
                         const DistinctMaps& maps, const Trust& trust, const Trust& witnesses,
                         const std::vector<std::vector<MapBreak>>& breaks, const ForEach& forEach) {
  const std::size_t n = site.runs.size();
  if (n == 0) return {};
  const SiteEvidence evidence{site,
                              pairs,
                              bends,
                              maps,
                              trust,
                              witnesses,
                              breaks,
                              coverageOf(site, maps, witnesses),
                              wallSightings(site, pairs, forEach),
                              roomCounts(site, pairs.pairs(), forEach),
                              comparedGraphs(site, pairs, forEach)};
  SiteMeasures all{std::vector<std::vector<Measure>>(n),
                   PairTable<std::vector<Measure>>(n, pairs.pairs())};
  forEach(n, [&](std::size_t i) {
    for (const MeasureRow& row : measureTable()) {
      if (!row.ofRun) continue;
      all.runs[i].push_back(measureOf(row.kind, row.ofRun(evidence, i)));
      auto& place = all.runs[i].back().place;
      if (place) place = site.poses[i](*place);
    }
  });
  for (const auto& [i, j] : pairs.pairs())
    for (const MeasureRow& row : measureTable())
      if (row.ofPair) all.pairs(i, j).push_back(measureOf(row.kind, row.ofPair(evidence, i, j)));
  return all;
}

}  // namespace roomgraph
