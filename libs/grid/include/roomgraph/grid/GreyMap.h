#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "roomgraph/base/Notes.h"
#include "roomgraph/grid/GridFrame.h"

namespace roomgraph {

/** A map as it was read, before any decision: how light each cell is. */
struct GreyMap {
  GridFrame frame;  ///< where its cells lie
  /** One for each cell, row-major, row 0 lowest. 0 is surely occupied, 255 surely free:
   *  255 * (1 - p(occupied)) for occupancy maps, (R + G + B + 1) / 3 for pictures. */
  std::vector<std::uint8_t> grey;
  /** The thresholds that the source's format calls for, as probabilities of being occupied: a cell
   *  is occupied from the one on and free up to the other. Without a format those of ROS. */
  double occupiedAbove = 0.65, freeBelow = 0.196;
  /** Where the map came from. */
  struct Source {
    std::string file;    ///< as the caller named it
    std::string kind;    ///< "gridmap", "simplemap", "metric_map", "ros_map", "rtabmap", ...
    std::string sha256;  ///< of the file's bytes (a yaml's, then its picture's), lower-case hex
    std::string
        insertion;  ///< how a simplemap was built into a grid, "key = value; ..."; else empty
  } source;
  Notes notes;  ///< on reading it
};

}  // namespace roomgraph
