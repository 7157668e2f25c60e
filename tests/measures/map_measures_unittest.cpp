#include "map_measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_building.h"
#include "drawn_drive.h"
#include "drawn_graph.h"
#include "graph_measures.h"

namespace roomgraph {
namespace {

using test::drawnGraph;
using test::everywhere;
using test::moved;
using test::patchesOver;

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

  Measure measure(std::size_t run, const std::string& name) const {
    const auto measures = graphMeasuresOf(comparedGraphs(site, pairs), trust, run);
    return *std::find_if(measures.begin(), measures.end(),
                         [&](const Measure& m) { return m.name == name; });
  }
};

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
  std::vector<bool> vertices(graph.vertices().size()), edges(graph.edges().size());
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = graph.vertices()[i].at.x < 10;
  for (std::size_t e = 0; e < edges.size(); ++e)
    edges[e] =
        vertices[graph.edges()[e].source.index()] && vertices[graph.edges()[e].target.index()];
  const PlacedGraphs graphs({graph, keepOnly(graph, vertices, edges), graph});
  EXPECT_NEAR(graphs.measure(0, "path_coverage").value.value(), 1, 1e-9);
  EXPECT_LT(graphs.measure(1, "path_coverage").value.value(), 0.6);
  EXPECT_NEAR(graphs.measure(1, "path_coverage").high.value(),
              graphs.measure(1, "path_coverage").low.value(), 1e-9);
  const auto pair = graphMeasuresOfPair(comparedGraphs(graphs.site, graphs.pairs)(0, 1));
  EXPECT_EQ(pair.front().name, "path_coverage");
  EXPECT_GT(pair.front().value.value(), graphs.measure(1, "path_coverage").value.value());
  EXPECT_LT(pair.front().value.value(), 1);
}

TEST(GraphMeasures, runsWithoutAGraphHaveNone) {
  const PlacedGraphs graphs(std::vector<TopologyGraph>(3));
  for (const Measure& measure :
       graphMeasuresOf(comparedGraphs(graphs.site, graphs.pairs), graphs.trust, 0)) {
    EXPECT_FALSE(measure.value) << measure.name;
    EXPECT_FALSE(measure.isMeaningful) << measure.name;
    EXPECT_EQ(measure.support, 0) << measure.name;
  }
}

TEST(Brokenness, isTheNumberOfBreaksWhereThereAreScans) {
  PlacedGraphs graphs(std::vector<TopologyGraph>(3));
  graphs.runs[1].scans.resize(40);
  const Measure found = brokennessOf(graphs.site, graphs.pairs, graphs.trust, 1, 2);
  EXPECT_EQ(found.value, 2);
  EXPECT_EQ(found.support, 40);
  EXPECT_TRUE(found.isMeaningful);
}

TEST(Brokenness, isWhatMostTrustSaysWhereThereAreNone) {
  PlacedGraphs graphs(std::vector<TopologyGraph>(4));
  const auto breakIn = [](FollowedWalls& followed) {
    const WallPatches patches = patchesOver({});
    for (FollowedPatch& f : followed.patches)
      if (patches[f.patch].middle.x > 10) f.pose = {0, 0.7, 0};
  };
  breakIn(graphs.pairs(0, 2).bInA), breakIn(graphs.pairs(1, 2).bInA);
  const Measure found = brokennessOf(graphs.site, graphs.pairs, graphs.trust, 2, 0);
  EXPECT_EQ(found.value, 1);
  EXPECT_EQ(found.low, 0);
  EXPECT_EQ(found.high, 1);
  EXPECT_EQ(found.unit, "pieces");
  EXPECT_EQ(brokennessOf(graphs.site, graphs.pairs, graphs.trust, 3, 0).value, 0);
}

TEST(Brokenness, oneRunAloneHasNone) {
  PlacedGraphs graphs(std::vector<TopologyGraph>(1));
  EXPECT_FALSE(brokennessOf(graphs.site, graphs.pairs, graphs.trust, 0, 0).value);
}

TEST(OwnMeasures, areOfTheMapAlone) {
  const Grid grid = test::drawnBuilding(4, {});
  roomgraph::Run run;
  run.map = mapForAlignment(grid, {});
  const std::vector<Measure> without = ownMeasuresOf(run);
  ASSERT_EQ(without.size(), 3u);
  EXPECT_TRUE(without[0].isMeaningful && without[1].isMeaningful);
  EXPECT_FALSE(without[2].value) << "no scans";
  EXPECT_FALSE(without[0].low);
  std::vector<Keyframe> frames = test::drawnDrive(grid);
  const std::vector<Keyframe> back(frames.rbegin(), frames.rend());
  frames.insert(frames.end(), back.begin(), back.end());
  run.scans = scanWalls(frames);
  EXPECT_TRUE(ownMeasuresOf(run)[2].isMeaningful);
}

}  // namespace
}  // namespace roomgraph
