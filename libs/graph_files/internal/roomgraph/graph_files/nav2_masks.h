#pragma once
#include <string>
#include <vector>

#include "roomgraph/grid/GridFrame.h"
#include "roomgraph/rooms/AreaGraph.h"

namespace roomgraph {

// Ours
// In:   AreaGraph
// Out:  the files of a mask for nav2's costmap filters, a ROS map that lies on the map
// Next: StagedFiles

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

}  // namespace roomgraph
