#pragma once
#include <string>
#include <vector>

#include "MapText.h"
#include "roomgraph/grid/thin_obstacles.h"
#include "roomgraph/rooms/find_rooms.h"
#include "roomgraph/topology/keep_inside.h"
#include "roomgraph/topology/voronoi_graph.h"

namespace roomgraph::test {

/** The inside of a map, ready to be split into regions. */
struct Inside {
  Grid grid;
  VoronoiGraph voronoi;
  InsideFlags isInside;
};

inline Inside insideOf(const MapText& map) {
  Inside inside{gridOf(map), {}, {}};
  inside.voronoi = voronoiGraph(obstacleCells(inside.grid, thinObstacles(inside.grid, {}), false));
  inside.isInside = keepInside(inside.voronoi, inside.grid, {});
  return inside;
}

/** A diagram and what a disc splits it into. */
struct DividedByDisc {
  VoronoiGraph voronoi;
  Regions regions;

  DividedByDisc(const MapText& map, double radius) {
    const Grid grid = gridOf(map);
    voronoi = voronoiGraph(obstacleCells(grid, thinObstacles(grid, {}), false));
    KeepInsideOptions options;
    options.outsideWidth = 2 * radius;
    options.freeOnly = false;
    regions = findRooms(voronoi, keepInside(voronoi, grid, options), radius, 0);
  }
};

/** Free cells (side 0.2 m) with a wall round them; then walls that leave out their gaps. */
class Plan {
 public:
  Plan(int width, int height)
      : rows_(std::size_t(height + 2), std::string(std::size_t(width + 2), '.')) {
    wall(0, 0, width + 2, 1);
    wall(0, height + 1, width + 2, 1);
    wall(0, 0, 1, height + 2);
    wall(width + 1, 0, 1, height + 2);
  }

  Plan& wall(int x, int y, int width, int height, char sign = '#') {
    for (int row = y; row < y + height; ++row)
      for (int column = x; column < x + width; ++column)
        rows_[std::size_t(row)][std::size_t(column)] = sign;
    return *this;
  }
  Plan& gap(int x, int y, int width, int height) { return wall(x, y, width, height, '.'); }

  Inside inside() const { return insideOf(drawn(rows_, 0.2)); }

 private:
  std::vector<std::string> rows_;
};

}  // namespace roomgraph::test
