#pragma once
#include <string>

#include "roomgraph/grid/GridFrame.h"
#include "roomgraph/rooms/AreaGraph.h"

namespace roomgraph {

// Ours
// In:   AreaGraph
// Out:  the bytes of a label picture
// Next: writeFileAtomically, readLabels

/** The labels of AreaGraph as the bytes of a PNG with 16 bits of grey: as many pixels as the map
 *  has cells, the map's highest row on top; 0 for none, else 1 + the id of the area. `frame` is the
 *  map's. readLabels() gives the labels back. Same labels, same bytes. O(cells). */
std::string areaLabelsPng(const AreaGraph& graph, const GridFrame& frame);

}  // namespace roomgraph
