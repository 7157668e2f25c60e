#include "roomgraph/grid/clear_wall_rims.h"

namespace roomgraph {
namespace {

constexpr Cell kDirections[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

/** How many unknown cells stand between a free cell and an occupied one in a direction, up to
 *  kWidestRim; none where there is something else, or more of them. */
std::optional<int> rimWidth(const Grid& grid, Cell free, Cell direction) {
  for (int width = 0; width <= kWidestRim; ++width) {
    const Cell next{free.x + (width + 1) * direction.x, free.y + (width + 1) * direction.y};
    const State state = grid.atOrUnknown(next);
    if (state == State::occupied) return width;
    if (state == State::free) return std::nullopt;
  }
  return std::nullopt;
}

/** Calls `visit` for each direction from a free cell to a wall, with the width of the rim. */
template <class Visit>
void forEachFace(const Grid& grid, Visit visit) {
  for (Cell c{0, 0}; c.y < grid.frame.height; ++c.y)
    for (c.x = 0; c.x < grid.frame.width; ++c.x) {
      if (grid.at(c) != State::free) continue;
      for (const Cell direction : kDirections)
        if (const auto width = rimWidth(grid, c, direction)) visit(c, direction, *width);
    }
}

}  // namespace

std::optional<Grid> clearWallRims(const Grid& grid) {
  std::size_t direct = 0, behindRims = 0;
  forEachFace(grid, [&](Cell, Cell, int width) { ++(width == 0 ? direct : behindRims); });
  if (behindRims <= direct) return std::nullopt;
  Grid cleared = grid;
  forEachFace(grid, [&](Cell c, Cell direction, int width) {
    for (int k = 1; k <= width; ++k)
      cleared.cells[grid.frame.index({c.x + k * direction.x, c.y + k * direction.y})] = State::free;
  });
  return cleared;
}

}  // namespace roomgraph
