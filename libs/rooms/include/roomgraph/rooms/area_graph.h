#pragma once
#include "roomgraph/base/Notes.h"
#include "roomgraph/rooms/AreaGraph.h"
#include "roomgraph/rooms/RoomGraph.h"
#include "roomgraph/rooms/SplitAtDoorsOptions.h"
#include "roomgraph/rooms/region_outlines.h"

namespace roomgraph {

// Ours, after Hou et al., "Area Graph: Generation of Topological Maps using the Voronoi Diagram",
// ICAR 2019
// In:   RegionOutlines, the map without clutter, and the RoomGraph
// Out:  AreaGraph
// Next: graphJson, areaLabelsPng, osmXml

/** The areas that the graph reaches, and their passages. An area is a region that the graph runs
 *  through, or that such a region meets in a passage; a room that is not in the graph is none.
 *  Passages are the openings between two areas through which a disc of `clearance` [m] passes; two
 *  areas may have several. Each has its evidence, by what a door is in `doors`. Every free cell of
 *  `grid` in an area has its label; those that clutter stands on are free in `grid`. Where the
 *  centre of a cell lies on the line between two areas it is in one of them. No more than
 *  kMaxLabelledAreas have labels; a note (code "too_many_areas") tells where there are more.
 *  O(cells + n log n). */
[[nodiscard]] AreaGraph areaGraph(const Grid& grid, const RegionOutlines& outlines,
                                  const RoomGraph& graph, double clearance,
                                  const SplitAtDoorsOptions& doors, Notes& notes);

}  // namespace roomgraph
