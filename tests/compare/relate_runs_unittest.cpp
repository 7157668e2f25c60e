#include "roomgraph/compare/relate_runs.h"

#include <gtest/gtest.h>

#include "drawn_building.h"

namespace roomgraph {
namespace {

using test::bent;
using test::drawnBuilding;

PreparedRun run(const Grid& grid) {
  PreparedRun run;
  run.map = mapForAlignment(grid, {});
  return run;
}

std::vector<PreparedRun> fourRuns() {
  return {run(bent(drawnBuilding(1, {3, -4, 0.4}), 0.08)), run(drawnBuilding(1, {-7, 2, 2.5})),
          run(drawnBuilding(1, {0, 1, -1.2})), run(drawnBuilding(11, {}))};
}

bool areAlike(const Transform2D& l, const Transform2D& r) {
  return distance(l.shift(), r.shift()) < 0.1 && std::abs(wrappedAngle(l.phi - r.phi)) < 0.01;
}

TEST(RelateRuns, theHubIsTheStraightestOfTheLargeRuns) {
  std::vector<PreparedRun> runs = fourRuns();
  runs.resize(3);
  const std::size_t hub = hubOf(runs);
  EXPECT_NE(hub, 0u) << "it is bent";
  runs[hub].map.freeArea = 1;
  EXPECT_NE(hubOf(runs), hub) << "it is small";
  EXPECT_EQ(hubOf({}), 0u);
}

TEST(RelateRuns, overTheHubComesOutWhatASearchFinds) {
  const std::vector<PreparedRun> runs = fourRuns();
  const std::vector<MapPair> related = test::related(runs);
  for (const auto& [a, b] : pairsOf(runs.size())) {
    const MapPair& over = related[pairIndex(a, b, runs.size())];
    const MapPair searched = relateMaps(runs[a].map, runs[b].map);
    EXPECT_EQ(over.alignment.isSameSite, searched.alignment.isSameSite) << a << ' ' << b;
    EXPECT_EQ(over.alignment.isSameSite, b < 3);
    if (b == 3) continue;
    EXPECT_TRUE(areAlike(over.alignment.pose, searched.alignment.pose)) << a << ' ' << b;
    EXPECT_NEAR(over.bInA.bend, searched.bInA.bend, 0.03);
    EXPECT_NEAR(over.aInB.bend, searched.aInB.bend, 0.03);
  }
}

TEST(RelateRuns, namingAPairTheOtherWayRoundSwapsTheAnswers) {
  const std::vector<PreparedRun> runs = fourRuns();
  const MapPair one = relateMaps(runs[0].map, runs[1].map);
  const MapPair back = swapped(relateMaps(runs[1].map, runs[0].map));
  EXPECT_TRUE(areAlike(one.alignment.pose, back.alignment.pose));
  EXPECT_NEAR(one.bInA.bend, back.bInA.bend, 1e-9);
  EXPECT_NEAR(one.aInB.share, back.aInB.share, 1e-9);
}

TEST(RelateRuns, copiesHaveNoBend) {
  const std::vector<PreparedRun> runs{run(drawnBuilding(2, {})), run(drawnBuilding(2, {}))};
  const MapPair pair = test::related(runs)[0];
  EXPECT_TRUE(pair.areIdentical);
  EXPECT_EQ(pair.bInA.bend, 0);
  EXPECT_EQ(pair.aInB.share, 1);
}

TEST(RelateRuns, thePairsAreNumberedInTheirOrder) {
  const auto pairs = pairsOf(6);
  for (std::size_t k = 0; k < pairs.size(); ++k)
    EXPECT_EQ(pairIndex(pairs[k].first, pairs[k].second, 6), k);
}

}  // namespace
}  // namespace roomgraph
