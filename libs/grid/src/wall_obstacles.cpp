#include "roomgraph/grid/wall_obstacles.h"

#include <array>

namespace roomgraph {
namespace {

constexpr int kRim = 2;  // cells
/** Drawings have 0 to 0.015 of them, maps of robots 0.15 to 0.7. */
constexpr double kLeastBeams = 0.05;

constexpr std::array<Cell, 5> kPlus{{{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

class SeenEdge {
 public:
  explicit SeenEdge(const Grid& grid) : grid_(grid) {}

  bool isNearWall(Cell cell) const {
    for (int y = cell.y - kRim; y <= cell.y + kRim; ++y)
      for (int x = cell.x - kRim; x <= cell.x + kRim; ++x)
        if (grid_.atOrUnknown({x, y}) == State::occupied) return true;
    return false;
  }

  bool hasBeams() const {
    std::size_t edge = 0, thin = 0;
    for (int y = 0; y < grid_.frame.height; ++y)
      for (int x = 0; x < grid_.frame.width; ++x) {
        const Cell cell{x, y};
        if (grid_.at(cell) != State::free || !touches(cell, State::unknown) || isNearWall(cell))
          continue;
        ++edge;
        thin += isThin(cell) ? 1 : 0;
      }
    return double(thin) > kLeastBeams * double(edge);
  }

 private:
  bool touches(Cell cell, State state) const {
    for (const Cell d : kPlus)
      if (grid_.atOrUnknown({cell.x + d.x, cell.y + d.y}) == state) return true;
    return false;
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
