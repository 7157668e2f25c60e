#include "roomgraph/topology/dead_ends.h"

#include <gtest/gtest.h>

#include "hand_built.h"

namespace roomgraph::test {
namespace {

TEST(RemoveDeadEnds, removesThemLayerByLayer) {
  // A twig with two short tips goes as a whole: first its tips, then itself.
  const TopologyGraph tree = joinedUp({{{0, 0}, 0.5, kJunction, {}},
                                       {{9, 0}, 0.5, kDeadEnd, {}},
                                       {{0, 9}, 0.5, kDeadEnd, {}},
                                       {{-0.4, 0}, 0.3, kJunction, {}},
                                       {{-0.6, 0.1}, 0.2, kDeadEnd, {}},
                                       {{-0.6, -0.1}, 0.2, kDeadEnd, {}}},
                                      {{0, 1}, {0, 2}, {0, 3}, {3, 4}, {3, 5}});
  const TopologyGraph pruned = removeDeadEnds(tree, {}, 0.1, leadsNowhere);
  EXPECT_EQ(pruned.vertices().size(), 2u);
  ASSERT_EQ(pruned.edges().size(), 1u);
  EXPECT_DOUBLE_EQ(pruned.edges()[0].path.length, 18);
}

TEST(RemoveDeadEnds, measuresTheReachBeyondTheJunctionsDisc) {
  DeadEndsOptions options;
  options.minReachRatio = 0.5;
  options.minReach = 0;
  // The tips' clearance is that of hand_built's obstacles, 1; so the reach is the length.
  EXPECT_EQ(removeDeadEnds(star({0.4, 3, 4}), options, 0.1, leadsNowhere).edges().size(), 1u);
  EXPECT_EQ(removeDeadEnds(star({0.6, 3, 4}), options, 0.1, leadsNowhere).edges().size(), 3u);
}

TEST(RemoveDeadEnds, whatEndsBetweenChairsLiesInTheirHall) {
  // The junction at the origin has a clearance of 1 m from chairs, and of 3.5 m from walls.
  const ObstacleCells walls{{100, 100, 0.1, {-5.05, -5.05}}, {{15, 50}}};
  const ObstacleRows rows(walls);
  EXPECT_EQ(removeDeadEnds(star({3, 9, 9}), {}, 0.1, leadsNowhere).edges().size(), 3u);
  EXPECT_EQ(removeEndsAmongClutter(star({3, 9, 9}), {}, rows, leadsNowhere).edges().size(), 1u);
  EXPECT_EQ(removeEndsAmongClutter(star({5, 9, 9}), {}, rows, leadsNowhere).edges().size(), 3u);
}

TEST(RemoveDeadEnds, whatLeadsOnStaysHoweverShort) {
  const auto leadsOn = [](const Vertex& tip, const Vertex&) { return tip.place.x > 0; };
  const TopologyGraph kept = removeDeadEnds(star({0.4, 3, 4, 5}), {}, 0.1, leadsOn);
  EXPECT_GT(kept.edges().size(),
            removeDeadEnds(star({0.4, 3, 4, 5}), {}, 0.1, leadsNowhere).edges().size());
  const ObstacleCells walls{{100, 100, 0.1, {-5.05, -5.05}}, {{15, 50}}};
  EXPECT_GT(
      removeEndsAmongClutter(star({3, 9, 9, 9}), {}, ObstacleRows(walls), leadsOn).edges().size(),
      removeEndsAmongClutter(star({3, 9, 9, 9}), {}, ObstacleRows(walls), leadsNowhere)
          .edges()
          .size());
}

TEST(RemoveDeadEnds, neverRemovesAWholeComponent) {
  const TopologyGraph kept = removeDeadEnds(star({0.1, 0.1, 0.1}), {}, 0.1, leadsNowhere);
  EXPECT_EQ(kept.vertices().size(), 1u);
  EXPECT_TRUE(kept.edges().empty());
  const TopologyGraph way = straightWays({{0, 0}, {0.1, 0}}, {{0, 1}});
  EXPECT_EQ(removeDeadEnds(way, {}, 0.1, leadsNowhere).edges().size(), 1u);
}

TEST(RemoveDeadEnds, thePapersWayRemovesEachOnceThenTheShort) {
  DeadEndsOptions options;
  options.allOnce = true;
  options.minLengthPx = 8;
  EXPECT_TRUE(removeDeadEnds(star({2, 3, 4}), options, 0.1, leadsNowhere).edges().empty());
  options.allOnce = false;
  EXPECT_EQ(removeDeadEnds(star({0.7, 3, 4}), options, 0.1, leadsNowhere).edges().size(), 1u);
  EXPECT_EQ(removeDeadEnds(star({0.9, 3, 4}), options, 0.1, leadsNowhere).edges().size(), 3u);
}

}  // namespace
}  // namespace roomgraph::test
