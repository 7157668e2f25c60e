#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "roomgraph/grid/GridFrame.h"
#include "roomgraph/rooms/AreaGraph.h"

namespace roomgraph {

// In:   AreaGraph
// Out:  a label picture; the pictures of masks for nav2's costmap filters, which lie on the map
// Next: readLabels, StagedFiles

/** The picture of a keepout mask: occupied in the rooms that are kept out, else free; its yaml is
 *  rosMapYaml(). Rooms that are not there have no cells. O(cells). */
std::string keepoutMaskPng(const AreaGraph& graph, const GridFrame& frame,
                           const std::vector<RoomId>& keptOut);

/** The picture of a speed mask: within 1 m of each passage narrower than 2 m the speed that the
 *  ways through it have in geojson(), else no limit. Grey is by how much speed is cut, white for
 *  none and black for all, as filters of type 1 with base 100 and multiplier -1 read it;
 *  its yaml is that of RosMapMode::scale.
 *  O(cells + passages). */
std::string speedMaskPng(const AreaGraph& graph, const GridFrame& frame);

/** The labels of AreaGraph as the bytes of a PNG with 16 bits of grey: as many pixels as the map
 *  has cells, the map's highest row on top; 0 for none, else 1 + the id of the area. `frame` is the
 *  map's. readLabels() gives the labels back. Same labels, same bytes. O(cells). */
std::string areaLabelsPng(const AreaGraph& graph, const GridFrame& frame);

/** Robots may go at full speed this far from obstacles [m]. */
constexpr double kFullSpeedClearance = 1;

/** Share of full speed at a clearance [m, %]: in proportion below, but never less than 20 %. */
inline double speedPercent(double clearance) {
  return std::clamp(std::round(100 * clearance / kFullSpeedClearance), 20.0, 100.0);
}

}  // namespace roomgraph
