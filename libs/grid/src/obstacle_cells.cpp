#include "roomgraph/grid/obstacle_cells.h"

#include <numeric>

#include "next_flag.h"

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
  // Flags are 0 or 1; narrow sums are taken of many at once.
  obstacles.cells.reserve(std::accumulate(isObstacle.begin(), isObstacle.end(), 0u));
  if (ringIsObstacle) addRingRow(grid, -1, obstacles.cells);
  for (int y = 0; y < frame.height; ++y) {
    if (ringIsObstacle && touchesFree(grid, {-1, y})) obstacles.cells.push_back({-1, y});
    const std::uint8_t* row = isObstacle.data() + frame.index({0, y});
    const auto next = [&](int x) { return nextFlag(row, frame.width, x); };
    for (int x = next(0); x < frame.width; x = next(x + 1)) obstacles.cells.push_back({x, y});
    if (ringIsObstacle && touchesFree(grid, {frame.width, y}))
      obstacles.cells.push_back({frame.width, y});
  }
  if (ringIsObstacle) addRingRow(grid, frame.height, obstacles.cells);
  return obstacles;
}

}  // namespace roomgraph
