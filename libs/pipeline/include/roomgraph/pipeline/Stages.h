#pragma once
#include <string>
#include <vector>

#include "roomgraph/base/Notes.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/Grid.h"
#include "roomgraph/grid/obstacle_cells.h"
#include "roomgraph/pipeline/ExtractOptions.h"
#include "roomgraph/rooms/AreaGraph.h"
#include "roomgraph/rooms/RoomGraph.h"
#include "roomgraph/rooms/border_vertices.h"
#include "roomgraph/rooms/region_outlines.h"
#include "roomgraph/topology/VoronoiGraph.h"
#include "roomgraph/topology/keep_clear.h"
#include "roomgraph/topology/keep_inside.h"

namespace roomgraph {

/** How long a step took. */
struct StageTiming {
  std::string stage;   ///< name of the step
  double seconds = 0;  ///< of wall time
};

/** Every intermediate result of an extraction, in the order of the steps. */
struct Stages {
  ExtractOptions options;   ///< those that were used
  GreyMap::Source source;   ///< which map it was
  Grid grid;                ///< IV-C: free, occupied, unknown
  ObstacleCells obstacles;  ///< IV-C, III-A
  VoronoiGraph voronoi;     ///< III-A
  InsideFlags isInside;     ///< III-A, per Voronoi vertex
  double clearance = 0;     ///< that every path keeps [m]
  EdgeIndices clearEdges;   ///< III-A, of `voronoi`
  TopologyGraph topology;   ///< III-A, as the Voronoi diagram gives it
  TopologyGraph pruned;     ///< III-A, without dead ends
  TopologyGraph joinedUp;   ///< III-A, with near vertices joined
  TopologyGraph kept;       ///< III-A, the graph without rooms
  ClearedMap cleared;       ///< end of IV-C: the map without clutter, for rooms and areas
  double roomRadius = 0;    ///< of the disc that rooms are found with [m]; 0 when split at doors
  RegionOutlines outlines;  ///< of that map: rooms and pieces of corridor
  Rooms rooms;              ///< III-B
  PathStretches stretches;  ///< III-C, per edge of `kept`
  TopologyGraph cut;        ///< III-D and E: paths cut, room ids set
  TopologyGraph cleaned;    ///< III-F: without short dead ends
  TopologyGraph doors;      ///< with doors between rooms joined to one vertex
  RoomGraph result;         ///< III-G
  AreaGraph areas;          ///< all that the graph reaches, in rooms and corridors
  Notes notes;              ///< of all steps
  std::vector<StageTiming> timings;  ///< in the order of the steps
};

}  // namespace roomgraph
