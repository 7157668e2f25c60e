#include "roomgraph/grid/wall_obstacles.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "next_flag.h"
#include "roomgraph/grid/clear_wall_rims.h"

namespace roomgraph {
namespace {

/** Drawings have 0 to 0.015 of them, maps of robots 0.15 to 0.7. */
constexpr double kLeastBeams = 0.05;

constexpr std::array<Cell, 5> kPlus{{{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

class SeenEdge {
 public:
  explicit SeenEdge(const Grid& grid)
      : grid_(grid), beyond_(std::size_t(grid.frame.width), State::unknown) {}

  bool isNearWall(Cell cell) const {
    if (grid_.atOrUnknown(cell) == State::occupied) return true;
    const int left = std::max(cell.x - kWidestRim, 0);
    const int right = std::min(cell.x + kWidestRim, grid_.frame.width - 1);
    const std::size_t count = std::size_t(right) + 1 - std::size_t(left);
    const int top = std::min(cell.y + kWidestRim, grid_.frame.height - 1);
    for (int y = std::max(cell.y - kWidestRim, 0); y <= top; ++y) {
      const State* row = grid_.cells.data() + grid_.frame.index({0, y});
      if (std::memchr(row + left, int(State::occupied), count)) return true;
    }
    return false;
  }

  bool hasBeams() const {
    std::size_t edge = 0, thin = 0;
    std::vector<std::uint8_t> isEdge(beyond_.size());
    for (int y = 0; y < grid_.frame.height; ++y) {
      findEdge(y, isEdge);
      const auto next = [&](int x) { return nextFlag(isEdge.data(), grid_.frame.width, x); };
      for (int x = next(0); x < grid_.frame.width; x = next(x + 1)) {
        const Cell cell{x, y};
        if (isNearWall(cell)) continue;
        ++edge;
        thin += isThin(cell) ? 1 : 0;
      }
    }
    return double(thin) > kLeastBeams * double(edge);
  }

 private:
  /** Which cells of a row are free and touch the unknown. */
  void findEdge(int y, std::vector<std::uint8_t>& isEdge) const {
    const std::size_t width = isEdge.size();
    const auto row = [&](int at) {
      const bool isIn = at >= 0 && at < grid_.frame.height;
      return isIn ? grid_.cells.data() + std::size_t(at) * width : beyond_.data();
    };
    const State *below = row(y - 1), *here = row(y), *above = row(y + 1);
    // No branch within, so that the compiler takes many cells at once.
    for (std::size_t x = 1; x + 1 < width; ++x) {
      const bool isAtUnknown = (below[x] == State::unknown) | (above[x] == State::unknown) |
                               (here[x - 1] == State::unknown) | (here[x + 1] == State::unknown);
      isEdge[x] = (here[x] == State::free) & isAtUnknown;
    }
    isEdge.front() = here[0] == State::free;
    isEdge.back() = here[width - 1] == State::free;
  }

  /** Whether it is in no plus of five free cells and in no square of nine, as corners are. */
  bool isThin(Cell cell) const {
    for (const Cell d : kPlus)
      if (isPlus({cell.x + d.x, cell.y + d.y})) return false;
    for (int y = cell.y - 1; y <= cell.y + 1; ++y)
      for (int x = cell.x - 1; x <= cell.x + 1; ++x)
        if (isSquare({x, y})) return false;
    return true;
  }

  bool isSquare(Cell centre) const {
    for (int y = centre.y - 1; y <= centre.y + 1; ++y)
      for (int x = centre.x - 1; x <= centre.x + 1; ++x)
        if (grid_.atOrUnknown({x, y}) != State::free) return false;
    return true;
  }

  bool isPlus(Cell centre) const {
    for (const Cell d : kPlus)
      if (grid_.atOrUnknown({centre.x + d.x, centre.y + d.y}) != State::free) return false;
    return true;
  }

  const Grid& grid_;
  std::vector<State> beyond_;  ///< the rows below and above the map
};

}  // namespace

std::vector<std::uint8_t> wallObstacles(const Grid& grid, const ObstacleCells& obstacles) {
  const SeenEdge edge(grid);
  std::vector<std::uint8_t> isWall(obstacles.cells.size(), 1);
  if (!edge.hasBeams()) return isWall;
  for (std::size_t i = 0; i < isWall.size(); ++i) isWall[i] = edge.isNearWall(obstacles.cells[i]);
  return isWall;
}

}  // namespace roomgraph
