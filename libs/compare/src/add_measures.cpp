#include "add_measures.h"

#include <algorithm>
#include <map>
#include <string>

#include "roomgraph/measures/graph_measures.h"
#include "roomgraph/measures/map_measures.h"

namespace roomgraph {
namespace {

void append(std::vector<Measure>& measures, const std::vector<Measure>& more) {
  measures.insert(measures.end(), more.begin(), more.end());
}

}  // namespace

void addMeasures(Comparison& result, const PlacedRuns& site,
                 const std::vector<std::vector<MapPair>>& pairs, const ForEach& forEach) {
  const ComparedGraphs graphs = comparedGraphs(site, pairs, forEach);
  std::map<std::string, std::size_t> places;  // by name
  for (std::size_t i = 0; i < site.runs.size(); ++i) places[site.runs[i]->name] = i;
  forEach(result.runs.size(), [&](std::size_t k) {
    ComparedRun& run = result.runs[k];
    const std::size_t i = places.at(run.name);
    const auto breaks = std::count_if(result.breaks.begin(), result.breaks.end(),
                                      [&](const MapBreak& found) { return found.run == run.name; });
    append(run.measures, graphMeasuresOf(graphs, site, i));
    run.measures.push_back(brokennessOf(site, pairs, i, std::size_t(breaks)));
    append(run.measures, ownMeasuresOf(*site.runs[i]));
  });
  for (ComparedPair& pair : result.pairs) {
    const auto a = places.find(pair.a), b = places.find(pair.b);
    if (a == places.end() || b == places.end()) continue;
    append(pair.measures,
           graphMeasuresOfPair(
               graphs[std::min(a->second, b->second)][std::max(a->second, b->second)]));
  }
}

}  // namespace roomgraph
