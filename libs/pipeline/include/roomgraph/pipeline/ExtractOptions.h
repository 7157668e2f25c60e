#pragma once
#include <string>

#include "roomgraph/base/Options.h"
#include "roomgraph/grid/LoadGridOptions.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/grid/clear_clutter.h"
#include "roomgraph/grid/thin_obstacles.h"
#include "roomgraph/rooms/find_rooms.h"
#include "roomgraph/rooms/join_doors.h"
#include "roomgraph/rooms/room_graph.h"
#include "roomgraph/rooms/short_dead_ends.h"
#include "roomgraph/rooms/split_at_doors.h"
#include "roomgraph/topology/dead_ends.h"
#include "roomgraph/topology/join_vertices.h"
#include "roomgraph/topology/keep_clear.h"
#include "roomgraph/topology/keep_components.h"
#include "roomgraph/topology/keep_inside.h"

namespace roomgraph {

/** The options of all steps, in the order of the pipeline. */
struct ExtractOptions {
  LoadGridOptions loadGrid;              ///< reading of maps
  BinarizeOptions binarize;              ///< IV-C
  ThinObstaclesOptions thinObstacles;    ///< IV-C
  KeepInsideOptions keepInside;          ///< III-A
  KeepClearOptions keepClear;            ///< III-A
  DeadEndsOptions deadEnds;              ///< III-A
  JoinVerticesOptions joinVertices;      ///< III-A
  KeepComponentsOptions keepComponents;  ///< III-A
  ClearClutterOptions clearClutter;      ///< end of IV-C
  FindRoomsOptions findRooms;            ///< III-B
  SplitAtDoorsOptions splitAtDoors;      ///< instead of III-B
  ShortDeadEndsOptions shortDeadEnds;    ///< III-F
  JoinDoorsOptions joinDoors;            ///< after III-F
  RoomGraphOptions roomGraph;            ///< III-G
};

/** Everything that is said about the options; points into `options`. */
[[nodiscard]] FieldTable describe(ExtractOptions& options);

/** "default": metres and three cell states. "paper": the paper's numbers, in cells.
 *  Throws UsageError for any other name. */
[[nodiscard]] ExtractOptions preset(const std::string& name);

}  // namespace roomgraph
