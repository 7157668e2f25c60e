#include "roomgraph/measures/measure_site.h"

#include <gtest/gtest.h>

#include "measure_table.h"
#include "placed_graphs.h"
#include "roomgraph/measures/measure_kinds.h"

namespace roomgraph {
namespace {

using test::PlacedGraphs;

TEST(MeasureSite, aSiteWithoutRunsHasNone) {
  const SiteMeasures none =
      measureSite({}, {}, {}, DistinctMaps(PairBends()), {}, {}, {}, oneByOne);
  EXPECT_TRUE(none.runs.empty());
  EXPECT_EQ(none.pairs.things(), 0u);
}

TEST(MeasureSite, eachMeasureOfTheTableIsThereInItsOrder) {
  const SiteMeasures all = PlacedGraphs(std::vector<TopologyGraph>(3)).measures();
  std::vector<std::string> ofRun, ofPair, run, pair;
  for (const MeasureRow& row : measureTable()) {
    if (row.ofRun) ofRun.push_back(row.kind.name);
    if (row.ofPair) ofPair.push_back(row.kind.name);
  }
  for (const Measure& measure : all.runs[2]) run.push_back(measure.name);
  for (const Measure& measure : all.pairs(0, 2)) pair.push_back(measure.name);
  EXPECT_EQ(run, ofRun);
  EXPECT_EQ(pair, ofPair);
}

TEST(MeasureSite, aMeasureHasTheUnitOfItsKindAndIsMeaningfulFromItsSupportOn) {
  const TopologyGraph graph = test::drawnGraph();
  const SiteMeasures all = PlacedGraphs({graph, graph, graph}).measures();
  for (const Measure& measure : all.runs[0]) {
    const MeasureKind& kind = *findMeasureKind(measure.name);
    EXPECT_EQ(measure.unit, kind.unit);
    const bool isSupported = measure.value && measure.support >= kind.leastSupport;
    if (measure.name == "coverage") continue;  // counts cells, and asks for square metres
    EXPECT_EQ(measure.isMeaningful, isSupported) << measure.name;
  }
  EXPECT_TRUE(find(all.runs[0], "path_coverage")->isMeaningful);
  const SiteMeasures two = PlacedGraphs({graph, graph}).measures();
  EXPECT_FALSE(find(two.runs[0], "path_coverage")->isMeaningful) << "a single other run";
  EXPECT_TRUE(find(two.pairs(0, 1), "path_coverage")->isMeaningful) << "of a pair";
}

}  // namespace
}  // namespace roomgraph
