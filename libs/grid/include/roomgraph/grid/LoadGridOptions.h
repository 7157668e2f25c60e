#pragma once
#include <string>

#include "roomgraph/base/Options.h"

namespace roomgraph {

/** How a map file becomes a grid. */
struct LoadGridOptions {
  double resolution = 0.05;                   ///< of a bare image, and of a simplemap's grid [m]
  bool isResolutionGiven = false;             ///< else a bare image gets a note that it is a guess
  double maxDistanceInsertion = 30;           ///< simplemap: ranges beyond this are not used [m]
  double maxOccupancyUpdateCertainty = 0.65;  ///< simplemap: how far one beam moves a cell
  bool considerInvalidRangesAsFreeSpace = true;  ///< simplemap: beams without return clear cells
  bool wideningBeamsWithDistance = false;        ///< simplemap: beams widen as they go
  double sliceLow = 0, sliceHigh = 0;  ///< of point clouds, above the floor [m]; 0, 0 to choose
  std::string layer;                   ///< of a metric map; empty for its first grid, else points
};
void describe(LoadGridOptions& options, FieldTable& table);

}  // namespace roomgraph
