#pragma once
#include "roomgraph/base/Options.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/Grid.h"

namespace roomgraph {

// Paper IV-C, step 1
// In:   GreyMap
// Out:  Grid
// Next: thinObstacles

struct BinarizeOptions {
  /** Sum R + G + B at or below which a cell is occupied, all others being free; 0 for three states
   *  with the thresholds of the map's own format. */
  int blackThreshold = 0;
  double occupiedAbove = 0;  ///< probability; 0 for that of the map's format
  double freeBelow = 0;      ///< probability; 0 for that of the map's format
};
void describe(BinarizeOptions& options, FieldTable& table);

/** Decides for each cell whether it is free, occupied or unknown. A cell exactly at a threshold is
 *  decided by it, free first, as ROS's map_server does. O(cells).
 *  @throws UsageError where the cells of the map are not those of its frame, or that is absurd. */
[[nodiscard]] Grid binarize(const GreyMap& map, const BinarizeOptions& options);

}  // namespace roomgraph
