#pragma once
#include <vector>

#include "roomgraph/grid/obstacle_cells.h"

namespace roomgraph {

/** The obstacle cells by rows, to ask how far a straight way keeps from them. Keeps a reference to
 *  those cells, which must outlive it. */
class ObstacleRows {
 public:
  /** O(rows). */
  explicit ObstacleRows(const ObstacleCells& obstacles);

  /** Distance from the segment a–b to the nearest centre of an obstacle cell [m], or `limit` where
   *  that is farther; where it is less than `enough`, any distance that is. O(cells within `limit`
   *  of the segment). */
  [[nodiscard]] double clearance(Point a, Point b, double limit, double enough = 0) const;

  /** Whether that is at least `least` [m]: sooner known where it is not. */
  [[nodiscard]] bool isClear(Point a, Point b, double least) const {
    return clearance(a, b, least, least) >= least;
  }

  [[nodiscard]] double cellSide() const { return obstacles_.frame.resolution; }  ///< [m]

 private:
  const ObstacleCells& obstacles_;
  std::vector<std::size_t> firstInRow_;  // from row -1 to one past row `height`
};

}  // namespace roomgraph
