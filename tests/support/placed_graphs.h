#pragma once
#include <string>
#include <vector>

#include "drawn_graph.h"
#include "roomgraph/measures/measure_site.h"

namespace roomgraph::test {

/** Runs with graphs and patches only, placed where they lie; equal trust. */
struct PlacedGraphs {
  std::vector<roomgraph::Run> runs;
  Site site;
  Trust trust;
  MapPairs pairs;

  explicit PlacedGraphs(const std::vector<TopologyGraph>& graphs) {
    for (const TopologyGraph& graph : graphs) {
      runs.emplace_back();
      runs.back().graph = graph;
      runs.back().map.patches = patchesOver({});
    }
    for (const roomgraph::Run& run : runs) site.runs.push_back(&run);
    site.poses.assign(runs.size(), {});
    trust.assign(runs.size(), 1);
    MapPair pair;
    pair.bInA = pair.aInB = everywhere(patchesOver({}), {});
    pairs = MapPairs(runs.size());
    for (const auto& [i, j] : pairs.pairs()) pairs(i, j) = pair;
  }
  PlacedGraphs(const PlacedGraphs&) = delete;

  SiteMeasures measures() const {
    const std::vector<std::vector<MapBreak>> breaks(runs.size());
    const PairBends bends(runs.size());
    return measureSite(site, pairs, bends, DistinctMaps(bends), trust, trust, breaks, oneByOne);
  }
  Measure measure(std::size_t run, const std::string& name) const {
    return *find(measures().runs[run], name);
  }
};

}  // namespace roomgraph::test
