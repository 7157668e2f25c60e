#pragma once
#include <string>
#include <vector>

#include "roomgraph/grid/ObstacleRows.h"
#include "roomgraph/rooms/AreaGraph.h"
#include "roomgraph/rooms/RoomGraph.h"

namespace roomgraph {

// In:   RoomGraph, the obstacles of its map, and the clearance that its paths keep
// Out:  the text of a GeoJSON file
// Next: writeFileAtomically

/** The graph as GeoJSON for the route server of nav2 (its GeoJsonGraphFileLoader), QGIS and others,
 *  in metres of the map frame.
 *
 *  A robot on a nav2 route goes straight from node to node, so each path is split at its bends
 *  (straightPieces) into nodes of kind "bend". Edges of nav2 are one-way, so each piece is there
 *  twice. Ids are unique over all: 0 to V-1 are our vertices, then come the bends by edge, then the
 *  pieces by edge, each one forth and then back.
 *
 *  Points have properties id, frame ("map") and metadata {class, clearance, room}; MultiLineStrings
 *  id, startid, endid, cost (length [m], overridable) and metadata {edge, class, room, length:
 *  those of our edge; min_clearance: that of our edge, or less where the straight piece comes
 *  nearer to an obstacle, but no less than `clearance` [m]; speed_limit: for AdjustSpeedLimit [% of
 *  the highest speed], 100 from 1 m of clearance on, less in proportion, at least 20; penalty: for
 *  PenaltyScorer [m], what the robot could drive in the time that this speed costs}; rooms are
 *  Polygons, off by a cell at most, with room, area, inscribed_radius and, where there are
 *  `roomNames` (by RoomId; more may follow), name; `passages` are MultiPoints, their two ends, with
 *  passage (their number), width, confidence and evidence (Passage). nav2 skips both, but not
 *  lines: since 2025 it takes each LineString for an edge, too, and stops at one without ids.
 *  class (SemanticScorer) is that of the vertex ("border", "room", ...), "bend", or of the edge
 *  ("room", "way", "corridor"). All numbers but ids have a point, as nav2 casts metadata to float
 *  and stops at an integer. It refuses a graph without edges, and a node without one is none: a
 *  vertex without a way gets one within its disc of clearance, to a node of class "bend". Same
 *  graph, same bytes. */
[[nodiscard]] std::string geojson(const RoomGraph& graph, const ObstacleRows& obstacles,
                                  double clearance, const std::vector<Passage>& passages = {},
                                  const std::vector<std::string>& roomNames = {});

}  // namespace roomgraph
