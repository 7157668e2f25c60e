#include "graph_measures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "placed_graphs.h"

namespace roomgraph {
namespace {

using test::drawnGraph;
using test::moved;
using test::PlacedGraphs;

TEST(GraphMeasures, aShiftedRunShowsInItsAccuracyOnly) {
  const TopologyGraph graph = drawnGraph();
  const PlacedGraphs graphs({graph, graph, moved(graph, {0.3, 0.4, 0})});
  EXPECT_NEAR(graphs.measure(2, "global_accuracy").value.value(), 0.5, 1e-9);
  EXPECT_NEAR(graphs.measure(2, "nearest_vertex").value.value(), 0.5, 1e-9);
  EXPECT_NEAR(graphs.measure(2, "relative_accuracy").value.value(), 0, 1e-9);
  EXPECT_NEAR(graphs.measure(2, "path_coverage").value.value(), 1, 1e-9);
  EXPECT_NEAR(graphs.measure(2, "path_frechet").value.value(), 0, 1e-9);
  EXPECT_TRUE(graphs.measure(2, "global_accuracy").isMeaningful);
}

TEST(GraphMeasures, theRangeIsThatWithAnyOtherRunLeftOut) {
  const TopologyGraph graph = drawnGraph();
  const PlacedGraphs graphs({graph, graph, moved(graph, {0.6, 0, 0})});
  const Measure accuracy = graphs.measure(0, "global_accuracy");
  EXPECT_NEAR(accuracy.value.value(), 0.6 / std::sqrt(2), 1e-9);
  EXPECT_NEAR(accuracy.low.value(), 0, 1e-9);
  EXPECT_NEAR(accuracy.high.value(), 0.6, 1e-9);
  EXPECT_EQ(accuracy.support, 2.0 * double(graph.vertices().size()));
}

TEST(GraphMeasures, aRunWithoutTrustHasNoVoice) {
  const TopologyGraph graph = drawnGraph();
  PlacedGraphs graphs({graph, graph, moved(graph, {0.6, 0, 0})});
  graphs.trust = {1, 1, 0};
  EXPECT_NEAR(graphs.measure(0, "global_accuracy").value.value(), 0, 1e-9);
  EXPECT_FALSE(graphs.measure(0, "global_accuracy").isMeaningful) << "a single other run";
  EXPECT_FALSE(graphs.measure(0, "global_accuracy").low);
}

TEST(GraphMeasures, coverageIsThatOfTheOthers) {
  const TopologyGraph graph = drawnGraph();
  const PlacedGraphs graphs({graph, test::westOf(graph, 10), graph});
  EXPECT_NEAR(graphs.measure(0, "path_coverage").value.value(), 1, 1e-9);
  EXPECT_LT(graphs.measure(1, "path_coverage").value.value(), 0.6);
  EXPECT_NEAR(graphs.measure(1, "path_coverage").high.value(),
              graphs.measure(1, "path_coverage").low.value(), 1e-9);
  const Measure pair = *find(graphs.measures().pairs(0, 1), "path_coverage");
  EXPECT_GT(pair.value.value(), graphs.measure(1, "path_coverage").value.value());
  EXPECT_LT(pair.value.value(), 1);
  EXPECT_FALSE(pair.low);
}

TEST(GraphMeasures, runsWithoutAGraphHaveNone) {
  const PlacedGraphs graphs(std::vector<TopologyGraph>(3));
  const std::vector<Measure> measures = graphs.measures().runs[0];
  for (const Measure& measure : measures) {
    if (measure.name == "brokenness") continue;
    EXPECT_FALSE(measure.value) << measure.name;
    EXPECT_FALSE(measure.isMeaningful) << measure.name;
    EXPECT_EQ(measure.support, 0) << measure.name;
  }
}

}  // namespace
}  // namespace roomgraph
