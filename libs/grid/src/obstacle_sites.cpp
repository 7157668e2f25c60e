#include "roomgraph/grid/obstacle_sites.h"

#include <algorithm>

namespace roomgraph {
namespace {

/** A cell just outside of the grid next to a free cell, diagonally too. */
bool touchesFree(const Grid& grid, Cell ring) {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const Cell near{ring.x + dx, ring.y + dy};
      if (grid.frame.contains(near) && grid.at(near) == State::free) return true;
    }
  return false;
}

void addRingRow(const Grid& grid, int y, std::vector<Cell>& sites) {
  for (int x = -1; x <= grid.frame.width; ++x)
    if (touchesFree(grid, {x, y})) sites.push_back({x, y});
}

}  // namespace

ObstacleSites obstacleSites(const Grid& grid, const std::vector<std::uint8_t>& obstacles,
                            bool ringIsObstacle) {
  const GridFrame& frame = grid.frame;
  ObstacleSites sites{frame, {}};
  sites.cells.reserve(std::size_t(
      std::count_if(obstacles.begin(), obstacles.end(), [](auto flag) { return flag != 0; })));
  if (ringIsObstacle) addRingRow(grid, -1, sites.cells);
  for (int y = 0; y < frame.height; ++y) {
    if (ringIsObstacle && touchesFree(grid, {-1, y})) sites.cells.push_back({-1, y});
    for (int x = 0; x < frame.width; ++x)
      if (obstacles[frame.index({x, y})]) sites.cells.push_back({x, y});
    if (ringIsObstacle && touchesFree(grid, {frame.width, y}))
      sites.cells.push_back({frame.width, y});
  }
  if (ringIsObstacle) addRingRow(grid, frame.height, sites.cells);
  return sites;
}

}  // namespace roomgraph
