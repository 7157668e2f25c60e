// The steps of the first half of the paper one by one, on a map made in memory: a corridor that
// runs round a block.
#include <cstdio>

#include "roomgraph/grid/binarize.h"
#include "roomgraph/grid/thin_obstacles.h"
#include "roomgraph/topology/topology_graph.h"
#include "roomgraph/topology/voronoi_graph.h"

using namespace roomgraph;  // NOLINT: a program, not a library

int main() {
  GreyMap map;
  map.frame = {60, 40, 0.1, {0, 0}};            // 6 m by 4 m
  map.grey.assign(map.frame.cellCount(), 255);  // free
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 60; ++x) {
      const bool isWall = x < 2 || y < 2 || x > 57 || y > 37;
      const bool isBlock = x > 20 && x < 40 && y > 15 && y < 25;
      if (isWall || isBlock) map.grey[map.frame.index({x, y})] = 0;
    }

  const Grid grid = binarize(map, {});  // IV-C
  const ObstacleCells obstacles = obstacleCells(grid, thinObstacles(grid, {}), false);
  const VoronoiGraph voronoi = voronoiGraph(obstacles);  // III-A
  const InsideFlags isInside = keepInside(voronoi, grid, {});
  const EdgeIndices clear = keepClear(voronoi, isInside, 0.3);
  const TopologyGraph graph = topologyGraph(voronoi, clear);
  std::printf("%zu obstacles, %zu Voronoi edges, %zu of them clear, %zu paths\n",
              obstacles.cells.size(), voronoi.edges.size(), clear.size(), graph.edges().size());
}
