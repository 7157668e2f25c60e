#pragma once
#include "roomgraph/areas/AreaGraph.h"
#include "roomgraph/base/Notes.h"
#include "roomgraph/grid/Grid.h"
#include "roomgraph/rooms/Regions.h"
#include "roomgraph/rooms/RoomGraph.h"
#include "roomgraph/voronoi/keep_inside.h"

namespace roomgraph {

// Ours, after Hou et al., "Area Graph: Generation of Topological Maps using the Voronoi Diagram",
// ICAR 2019
// In:   the map without clutter with its VoronoiGraph and Regions, and the RoomGraph
// Out:  AreaGraph
// Next: graphJson, areaLabelsPng, osmXml

/** What areas are made from; all of one map, and of that map without clutter. */
struct ClearedSpace {
  const Grid& grid;
  const VoronoiGraph& voronoi;
  const InsideFlags& isInside;
  const Regions& regions;
};

/** The areas that the graph reaches, and their passages. An area is a region that the graph runs
 *  through, or that such a region meets in a passage; a room that is not in the graph is none.
 *  Passages are the openings between two areas through which a disc of `clearance` [m] passes; two
 *  areas may have several. Every free cell of these regions, cells of clutter among them, gets the
 *  label of the area whose polygon holds its centre; free cells in no polygon, in corners that are
 *  too narrow for one, get that of the area that is nearest by way of such cells. Where a centre
 *  lies on the line between two areas it is in one of them. No more than 65534 areas have labels;
 *  a note tells where there are more. O(cells + n log n). */
AreaGraph areaGraph(const ClearedSpace& space, const RoomGraph& graph, double clearance,
                    Notes& notes);

}  // namespace roomgraph
