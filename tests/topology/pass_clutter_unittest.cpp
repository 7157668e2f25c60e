#include "roomgraph/topology/pass_clutter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "hand_built.h"
#include "random_maps.h"
#include "roomgraph/base/UnionFind.h"
#include "roomgraph/grid/clear_clutter.h"
#include "roomgraph/grid/thin_obstacles.h"
#include "roomgraph/topology/topology_graph.h"
#include "roomgraph/topology/voronoi_graph.h"

namespace roomgraph::test {
namespace {

struct Passed {
  TopologyGraph before, after;
};

Passed passed(const MapText& map, double maxSize) {
  const Grid grid = gridOf(map);
  const ObstacleCells obstacles = obstacleCells(grid, thinObstacles(grid, {}), hasUnknown(map));
  const VoronoiGraph voronoi = voronoiGraph(obstacles);
  const EdgeIndices kept = keepClear(voronoi, keepInside(voronoi, grid, {}), 0.2);
  const ClearedMap cleared = clearClutter(grid, obstacles, {maxSize});
  const auto isClutter = [&](Point at) {
    return cleared.grid.atOrUnknown(grid.frame.cellAt(at)) == State::free;
  };
  Passed all;
  all.before =
      removeDeadEnds(topologyGraph(voronoi, kept), {}, grid.frame.resolution, leadsNowhere);
  ObstacleCells walls{obstacles.frame, {}};
  for (const Cell cell : obstacles.cells)
    if (cleared.grid.atOrUnknown(cell) != State::free) walls.cells.push_back(cell);
  all.after = passClutter(all.before, isClutter, ObstacleRows(walls), {}, leadsNowhere);
  return all;
}

std::size_t partCount(const TopologyGraph& graph) {
  UnionFind parts(graph.vertices().size());
  for (const Edge& edge : graph.edges())
    parts.join(std::uint32_t(edge.source.index()), std::uint32_t(edge.target.index()));
  std::set<std::uint32_t> found;
  for (std::uint32_t v = 0; v < graph.vertices().size(); ++v) found.insert(parts.find(v));
  return found.size();
}

std::size_t ringCount(const TopologyGraph& graph) {
  return graph.edges().size() + partCount(graph) - graph.vertices().size();
}

/** A corridor of 1.8 x 9.8 m with boxes of 0.4 m, so many cells above its lower wall and with so
 *  many cells between them. */
std::vector<std::string> corridorWithBoxes(std::size_t gap, std::size_t count = 1,
                                           std::size_t between = 0) {
  std::vector<std::string> rows(20, "#" + std::string(98, '.') + "#");
  rows.front() = rows.back() = std::string(100, '#');
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t y = 0; y < 4; ++y)
      rows[18 - gap - y].replace(28 + i * (4 + between), 4, "####");
  return rows;
}

Passed corridor(const std::vector<std::string>& rows, double maxSize = 0.6) {
  return passed(drawn(rows, 0.1), maxSize);
}

TEST(PassClutter, pathsPassItOnItsWiderSide) {
  const Passed all = corridor(corridorWithBoxes(5));
  EXPECT_EQ(ringCount(all.before), 1u);
  ASSERT_EQ(all.after.edges().size(), 1u);
  double lowest = 2;
  for (const Point at : all.after.edges()[0].path.points) lowest = std::min(lowest, at.y);
  EXPECT_GT(lowest, 0.9) << "below the box";
}

TEST(PassClutter, aRowIsPassedAsOne) {
  const Passed all = corridor(corridorWithBoxes(6, 5, 6));
  EXPECT_EQ(ringCount(all.before), 5u);
  EXPECT_EQ(all.after.edges().size(), 1u) << "with paths that end behind the row";
}

TEST(PassClutter, whatLiesBehindItKeepsItsWay) {
  std::vector<std::string> rows = corridorWithBoxes(6, 5, 6);
  for (std::string& row : rows) row.replace(row.size() - 1, 1, ".");
  rows.back().replace(46, 7, ".......");
  for (int i = 0; i < 20; ++i)
    rows.push_back(std::string(46, '#') + "......." + std::string(47, '#'));
  rows.push_back(std::string(100, '#'));
  const Passed all = corridor(rows);
  EXPECT_EQ(partCount(all.after), 1u);
  double lowest = 9;
  for (const Vertex& vertex : all.after.vertices()) lowest = std::min(lowest, vertex.place.y);
  EXPECT_LT(lowest, 1) << "the end of the side corridor";
}

TEST(PassClutter, goesRoundWhatIsNoClutter) {
  EXPECT_EQ(ringCount(corridor(corridorWithBoxes(5), 0.5).after), 1u);
}

TEST(PassClutter, aRingThatOnlyThePoseCouldOpenStays) {
  EXPECT_EQ(ringCount(corridor(corridorWithBoxes(7)).after), 1u);
}

TEST(PassClutter, equalWaysAmongClutterAllGo) {
  const Passed all = corridor(corridorWithBoxes(7, 5, 5));
  EXPECT_EQ(ringCount(all.before), 5u);
  EXPECT_EQ(ringCount(all.after), 1u) << "round the row";
}

TEST(PassClutter, ofTwoWaysAsNarrowTheShorterIsClosed) {
  std::vector<std::string> rows = corridorWithBoxes(7);
  rows[8].replace(28, 4, ".##.");  // without its upper corners
  const Passed all = corridor(rows);
  EXPECT_EQ(ringCount(all.before), 1u);
  EXPECT_EQ(ringCount(all.after), 0u);
}

TEST(PassClutter, partsNothing) {
  std::size_t opened = 0;
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    const Passed all = passed(noisyOffice(seed, 220), 0.6);
    EXPECT_EQ(partCount(all.after), partCount(all.before));
    opened += ringCount(all.before) - ringCount(all.after);
  }
  EXPECT_GT(opened, 5u);
}

}  // namespace
}  // namespace roomgraph::test
