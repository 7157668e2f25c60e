#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/grid/GridFrame.h"

namespace roomgraph {

/** What the beams of one run say of each cell: how many ended in it, and how many passed. */
class CellVotes {
 public:
  explicit CellVotes(const GridFrame& frame) : frame_(frame), votes_(frame.cellCount()) {}

  /** A beam from `eye` to where it met something; both must lie in the frame. The cell of the end
   *  gets a hit, all between a pass (Bresenham 1965). */
  void addBeam(Point eye, Point end);

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
