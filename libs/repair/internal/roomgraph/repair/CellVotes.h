#pragma once
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/grid/GridFrame.h"

namespace roomgraph {

/** All cells that a beam passes, from that of `eye` to the one before that of `end`, in this order
 *  (Bresenham 1965): `visit` is told each. Both must lie in the frame. */
template <class Visit>
void passBeam(const GridFrame& frame, Point eye, Point end, const Visit& visit) {
  Cell at = frame.cellAt(eye);
  const Cell last = frame.cellAt(end);
  const int width = std::abs(last.x - at.x), height = -std::abs(last.y - at.y);
  const int stepX = at.x < last.x ? 1 : -1, stepY = at.y < last.y ? 1 : -1;
  for (int error = width + height; at.x != last.x || at.y != last.y;) {
    visit(frame.index(at));
    const int twice = 2 * error;
    if (twice >= height) error += height, at.x += stepX;
    if (twice <= width) error += width, at.y += stepY;
  }
}

/** What the beams of one run say of each cell: how many ended in it, and how many passed. */
class CellVotes {
 public:
  explicit CellVotes(const GridFrame& frame) : frame_(frame), votes_(frame.cellCount()) {}

  /** A beam from `eye` to where it met something; both must lie in the frame. The cell of the end
   *  gets a hit, all between a pass. */
  void addBeam(Point eye, Point end) {
    passBeam(frame_, eye, end, [&](std::size_t cell) { ++votes_[cell].passes; });
    ++votes_[frame_.index(frame_.cellAt(end))].hits;
  }

  std::uint32_t seen(std::size_t cell) const { return votes_[cell].hits + votes_[cell].passes; }
  /** Share of the beams that ended there, 0 to 1; 0 where none came. */
  double wallShare(std::size_t cell) const {
    return seen(cell) > 0 ? double(votes_[cell].hits) / seen(cell) : 0;
  }

 private:
  struct Vote {
    std::uint32_t hits = 0, passes = 0;
  };

  GridFrame frame_;
  std::vector<Vote> votes_;
};

}  // namespace roomgraph
