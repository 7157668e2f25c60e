#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "roomgraph/grid/GridFrame.h"
#include "roomgraph/map_files/ros_map_yaml.h"

namespace roomgraph {

/** Which greys of a mask mark something, as nav2's map server reads them. */
class MaskGreys {
 public:
  explicit MaskGreys(const RosMapYaml& yaml);

  bool isMarked(std::uint8_t grey) const { return marks_[grey] > 0; }
  /** How much: the cost that the cell gets, 0 to 100. */
  int mark(std::uint8_t grey) const { return marks_[grey]; }
  std::uint8_t free() const { return free_; }  ///< a grey that marks nothing

 private:
  std::array<int, 256> marks_{};
  std::uint8_t free_ = 255;
};

/** A connected region of marked cells, by their numbers, ascending. */
using MaskRegion = std::vector<std::size_t>;

/** The regions of cells that touch each other, also at corners, by their first cells. O(cells). */
std::vector<MaskRegion> maskRegions(const GridFrame& frame, const std::vector<bool>& isMarked);

/** The cells whose centres lie in a four-cornered cell that was bent, and that in which its middle
 *  lies. */
std::vector<Cell> cellsIn(const GridFrame& frame, const std::array<Point, 4>& corners);

}  // namespace roomgraph
