#pragma once
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
  [[nodiscard]] bool isFree(Point p) const { return atOrUnknown(frame.cellAt(p)) == State::free; }
};

}  // namespace roomgraph
