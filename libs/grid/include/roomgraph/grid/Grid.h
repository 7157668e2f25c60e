#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "roomgraph/grid/GridFrame.h"

namespace roomgraph {

enum class State : std::uint8_t { unknown, free, occupied };  ///< of a cell

/** A map with one decision per cell. */
struct Grid {
  GridFrame frame;           ///< where its cells lie
  std::vector<State> cells;  ///< row-major, row 0 lowest

  [[nodiscard]] State at(Cell c) const { return cells[frame.index(c)]; }  ///< must be inside
  /** What lies beyond the border is unknown. */
  [[nodiscard]] State atOrUnknown(Cell c) const {
    return frame.contains(c) ? at(c) : State::unknown;
  }
  /** How many of the four cells beside `c` are of this state. */
  [[nodiscard]] int countBeside(Cell c, State state) const {
    const auto is = [&](int dx, int dy) { return atOrUnknown({c.x + dx, c.y + dy}) == state; };
    return is(1, 0) + is(-1, 0) + is(0, 1) + is(0, -1);
  }
  /** Whether any cell is of this state. O(cells). */
  [[nodiscard]] bool has(State state) const {
    return std::find(cells.begin(), cells.end(), state) != cells.end();
  }
  /** On the border of cells all of them have to be free: rounding must not decide, nor the pose of
   *  the map. */
  [[nodiscard]] bool isFree(Point p) const {
    constexpr double kOnBorder = 1e-6;  // how near to it a place is on it [cells]
    const double x = (p.x - frame.origin.x) / frame.resolution;
    const double y = (p.y - frame.origin.y) / frame.resolution;
    if (!(x >= kOnBorder && y >= kOnBorder && x < frame.width - kOnBorder &&
          y < frame.height - kOnBorder))
      return false;
    const Cell low{int(x - kOnBorder), int(y - kOnBorder)};
    const Cell high{int(x + kOnBorder), int(y + kOnBorder)};
    const auto isFreeAt = [&](Cell cell) { return at(cell) == State::free; };
    if (low.x == high.x && low.y == high.y) return isFreeAt(low);
    return isFreeAt(low) && isFreeAt(high) && isFreeAt({low.x, high.y}) &&
           isFreeAt({high.x, low.y});
  }
};

}  // namespace roomgraph
