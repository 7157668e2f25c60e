#include "roomgraph/topology/pass_clutter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "random_maps.h"
#include "roomgraph/base/UnionFind.h"
#include "roomgraph/grid/clear_clutter.h"
#include "roomgraph/grid/thin_obstacles.h"
#include "roomgraph/voronoi/voronoi_graph.h"

namespace roomgraph::test {
namespace {

struct Passed {
  VoronoiGraph voronoi;
  EdgeIndices before, after;
};

bool nowhere(Point) { return false; }

Passed passed(const MapText& map, double maxSize,
              const std::function<bool(Point)>& isInRoom = nowhere) {
  const Grid grid = gridOf(map);
  const ObstacleCells obstacles = obstacleCells(grid, thinObstacles(grid, {}), hasUnknown(map));
  Passed all{voronoiGraph(obstacles), {}, {}};
  all.before = keepClear(all.voronoi, keepInside(all.voronoi, grid, {}), 0.2);
  const ClearedMap cleared = clearClutter(grid, obstacles, {maxSize});
  all.after = passClutter(all.voronoi, all.before, cleared.isClutter, isInRoom);
  return all;
}

std::size_t partCount(const VoronoiGraph& voronoi, const EdgeIndices& edges) {
  UnionFind parts(voronoi.vertices.size());
  for (const auto e : edges) parts.join(voronoi.edges[e].source, voronoi.edges[e].target);
  std::set<std::uint32_t> found;
  for (const auto e : edges) found.insert(parts.find(voronoi.edges[e].source));
  return found.size();
}

/** Edges that can go until no way round anything is left. */
std::size_t ringCount(const VoronoiGraph& voronoi, const EdgeIndices& edges) {
  UnionFind parts(voronoi.vertices.size());
  return std::size_t(std::count_if(edges.begin(), edges.end(), [&](std::uint32_t e) {
    return !parts.join(voronoi.edges[e].source, voronoi.edges[e].target);
  }));
}

std::size_t ringsLeft(const Passed& all) { return ringCount(all.voronoi, all.after); }

/** A corridor of 1.8 x 5.8 m with a box of 0.4 m, so many cells above its lower wall. */
std::vector<std::string> corridorWithABox(std::size_t gap) {
  std::vector<std::string> rows(20, "#" + std::string(58, '.') + "#");
  rows.front() = rows.back() = std::string(60, '#');
  for (std::size_t y = 0; y < 4; ++y) rows[18 - gap - y].replace(28, 4, "####");
  return rows;
}

TEST(PassClutter, pathsPassItOnItsWiderSide) {
  const Passed all = passed(drawn(corridorWithABox(5), 0.1), 0.6);
  ASSERT_EQ(ringCount(all.voronoi, all.before), 1u);
  EXPECT_EQ(ringsLeft(all), 0u);
  for (const auto e : all.before) {
    const VoronoiEdge& edge = all.voronoi.edges[e];
    const bool isKept = std::binary_search(all.after.begin(), all.after.end(), e);
    if (!isKept) EXPECT_LT(all.voronoi.vertices[edge.source].at.y, 1.05) << "below the box";
  }
}

TEST(PassClutter, goesRoundWhatIsNoClutter) {
  const Passed large = passed(drawn(corridorWithABox(5), 0.1), 0.5);
  EXPECT_EQ(large.after, large.before);
}

TEST(PassClutter, leavesRoomsAsTheyAre) {
  const Passed all =
      passed(drawn(corridorWithABox(5), 0.1), 0.6, [](Point at) { return at.x > 3; });
  EXPECT_EQ(all.after, all.before) << "half of the ring is in a room";
}

TEST(PassClutter, aRingThatOnlyThePoseCouldOpenStays) {
  EXPECT_EQ(ringsLeft(passed(drawn(corridorWithABox(7), 0.1), 0.6)), 1u);
}

TEST(PassClutter, ofTwoPassagesAsNarrowTheLongerIsClosed) {
  std::vector<std::string> rows = corridorWithABox(7);
  rows[8].replace(28, 4, ".##.");  // without its upper corners
  const Passed all = passed(drawn(rows, 0.1), 0.6);
  ASSERT_EQ(ringCount(all.voronoi, all.before), 1u);
  EXPECT_EQ(ringsLeft(all), 0u);
}

TEST(PassClutter, partsNothing) {
  std::size_t opened = 0;
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    const Passed all = passed(noisyOffice(seed, 220), 0.6);
    EXPECT_TRUE(std::is_sorted(all.after.begin(), all.after.end()));
    EXPECT_TRUE(
        std::includes(all.before.begin(), all.before.end(), all.after.begin(), all.after.end()));
    EXPECT_EQ(partCount(all.voronoi, all.after), partCount(all.voronoi, all.before));
    opened += ringCount(all.voronoi, all.before) - ringsLeft(all);
  }
  EXPECT_GT(opened, 5u);
}

}  // namespace
}  // namespace roomgraph::test
