#include "roomgraph/grid/obstacle_cells.h"

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

void addRingRow(const Grid& grid, int y, std::vector<Cell>& cells) {
  for (int x = -1; x <= grid.frame.width; ++x)
    if (touchesFree(grid, {x, y})) cells.push_back({x, y});
}

}  // namespace

ObstacleCells obstacleCells(const Grid& grid, const std::vector<std::uint8_t>& isObstacle,
                            bool ringIsObstacle) {
  const GridFrame& frame = grid.frame;
  ObstacleCells obstacles{frame, {}};
  obstacles.cells.reserve(std::size_t(
      std::count_if(isObstacle.begin(), isObstacle.end(), [](auto flag) { return flag != 0; })));
  if (ringIsObstacle) addRingRow(grid, -1, obstacles.cells);
  for (int y = 0; y < frame.height; ++y) {
    if (ringIsObstacle && touchesFree(grid, {-1, y})) obstacles.cells.push_back({-1, y});
    for (int x = 0; x < frame.width; ++x)
      if (isObstacle[frame.index({x, y})]) obstacles.cells.push_back({x, y});
    if (ringIsObstacle && touchesFree(grid, {frame.width, y}))
      obstacles.cells.push_back({frame.width, y});
  }
  if (ringIsObstacle) addRingRow(grid, frame.height, obstacles.cells);
  return obstacles;
}

}  // namespace roomgraph
