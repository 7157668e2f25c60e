#include "wall_sharpness.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "roomgraph/align/scan_walls.h"

namespace roomgraph {
namespace {

/** Steps along rows and columns to the nearest free cell, at most `most`. */
std::vector<std::uint8_t> stepsToFree(const Grid& grid, std::uint8_t most) {
  const int w = grid.frame.width, h = grid.frame.height;
  std::vector<std::uint8_t> steps(grid.frame.cellCount());
  const auto relax = [&](int x, int y, int fromX, int fromY) {
    if (fromX < 0 || fromY < 0 || fromX >= w || fromY >= h) return;
    std::uint8_t& mine = steps[grid.frame.index({x, y})];
    mine = std::min<std::uint8_t>(mine, std::uint8_t(steps[grid.frame.index({fromX, fromY})] + 1));
  };
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      steps[grid.frame.index({x, y})] = grid.at({x, y}) == State::free ? 0 : most;
      relax(x, y, x - 1, y), relax(x, y, x, y - 1);
    }
  for (int y = h; y-- > 0;)
    for (int x = w; x-- > 0;) relax(x, y, x + 1, y), relax(x, y, x, y + 1);
  return steps;
}

bool isEdge(const Grid& grid, Cell c) {
  if (grid.at(c) != State::free) return false;
  for (const Cell d : {Cell{-1, 0}, Cell{1, 0}, Cell{0, -1}, Cell{0, 1}})
    if (grid.atOrUnknown({c.x + d.x, c.y + d.y}) != State::free) return true;
  return false;
}

}  // namespace

std::optional<double> wallSharpness(const Grid& grid) {
  // What lies behind the face of a wall like ends of beams on one wall is wall as well.
  const int reach = std::clamp(int(std::lround(kSameSurface / grid.frame.resolution)), 1, 200);
  const std::vector<std::uint8_t> steps = stepsToFree(grid, std::uint8_t(reach + 1));
  double edge = 0, walls = 0;
  for (int y = 0; y < grid.frame.height; ++y)
    for (int x = 0; x < grid.frame.width; ++x) {
      edge += isEdge(grid, {x, y});
      walls += grid.at({x, y}) == State::occupied && steps[grid.frame.index({x, y})] <= reach;
    }
  if (edge == 0 || walls == 0) return std::nullopt;
  return walls / edge;
}

}  // namespace roomgraph
