#include "roomgraph/topology/voronoi_without.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "drawn_obstacles.h"
#include "random_maps.h"
#include "roomgraph/topology/voronoi_graph.h"

namespace roomgraph::test {
namespace {

using Place = std::pair<long, long>;
using Line = std::tuple<Place, Place, long>;

long micro(double x) { return std::lround(x * 1e6); }

/** The edges by their ends and clearances, rounded and sorted: the same for the same diagram,
 *  however its parts are numbered. */
std::vector<Line> linesOf(const VoronoiGraph& graph) {
  std::vector<Line> lines;
  for (const VoronoiEdge& edge : graph.edges) {
    const Point a = graph.vertices[edge.source].place;
    const Point b = edge.isInfinite() ? a : graph.vertices[edge.target].place;
    Place first{micro(a.x), micro(a.y)}, last{micro(b.x), micro(b.y)};
    if (last < first) std::swap(first, last);
    lines.push_back({first, last, micro(edge.minClearance)});
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

VoronoiGraph fromScratch(const ObstacleCells& obstacles,
                         const std::vector<std::uint8_t>& isLeftOut) {
  ObstacleCells kept{obstacles.frame, {}};
  for (std::size_t i = 0; i < obstacles.cells.size(); ++i)
    if (!isLeftOut[i]) kept.cells.push_back(obstacles.cells[i]);
  return voronoiGraph(kept);
}

/** One flag per obstacle: whether its cell is one of `cells`. */
std::vector<std::uint8_t> flagsOf(const ObstacleCells& obstacles, const std::vector<Cell>& cells) {
  std::vector<std::uint8_t> flags;
  for (const Cell cell : obstacles.cells)
    flags.push_back(std::any_of(cells.begin(), cells.end(),
                                [&](Cell c) { return c.x == cell.x && c.y == cell.y; }));
  return flags;
}

TEST(VoronoiWithout, isTheDiagramOfTheOtherObstacles) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const ObstacleCells obstacles = obstaclesOf(randomMap(seed, 40, 30, 0.1));
    std::vector<std::uint8_t> isLeftOut(obstacles.cells.size());
    for (std::size_t i = 0; i < isLeftOut.size(); ++i) {
      const Cell cell = obstacles.cells[i];
      isLeftOut[i] = cell.x > 8 && cell.x < 30 && cell.y > 8 && cell.y < 20 && (i + seed) % 3 == 0;
    }
    const VoronoiGraph without = voronoiWithout(voronoiGraph(obstacles), obstacles, isLeftOut);
    EXPECT_EQ(linesOf(without), linesOf(fromScratch(obstacles, isLeftOut))) << seed;
  }
}

TEST(VoronoiWithout, nothingIsTheSameDiagram) {
  const ObstacleCells obstacles = obstaclesOf(randomMap(4, 40, 30, 0.1));
  const VoronoiGraph graph = voronoiGraph(obstacles);
  const auto none = std::vector<std::uint8_t>(obstacles.cells.size(), 0);
  EXPECT_EQ(linesOf(voronoiWithout(graph, obstacles, none)), linesOf(graph));
}

void expectNumbersKept(const std::vector<std::string>& rows, const std::vector<Cell>& cells) {
  const ObstacleCells obstacles = obstaclesOf(drawn(rows, 1));
  const std::vector<std::uint8_t> isLeftOut = flagsOf(obstacles, cells);
  ASSERT_EQ(std::size_t(std::count(isLeftOut.begin(), isLeftOut.end(), 1)), cells.size());
  const VoronoiGraph graph = voronoiGraph(obstacles);
  const VoronoiGraph without = voronoiWithout(graph, obstacles, isLeftOut);
  EXPECT_EQ(linesOf(without), linesOf(fromScratch(obstacles, isLeftOut)));
  ASSERT_EQ(without.obstacles, graph.obstacles);
  for (const VoronoiEdge& edge : without.edges) {
    EXPECT_FALSE(isLeftOut[edge.left] || isLeftOut[edge.right]);
    EXPECT_NEAR(distance(without.obstacles[edge.left], without.vertices[edge.source].place),
                without.vertices[edge.source].clearance, 1e-9);
  }
}

TEST(VoronoiWithout, theSitesKeepTheirNumbers) {
  const std::vector<std::string> room{"########", "#......#", "#......#", "#..##..#",
                                      "#......#", "#......#", "########"};
  expectNumbersKept(room, {{3, 3}, {4, 3}});
}

TEST(VoronoiWithout, theSitesKeepTheirNumbersAtTheHull) {
  // What stands alone outside of all others leaves a hole that is open to infinity.
  const std::vector<std::string> yard{"..........", ".####..#..", ".#..#.....", ".####.....",
                                      ".........."};
  expectNumbersKept(yard, {{7, 3}});
}

}  // namespace
}  // namespace roomgraph::test
