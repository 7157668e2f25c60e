#pragma once
#include <optional>
#include <vector>

#include "roomgraph/rooms/AreaGraph.h"
#include "roomgraph/rooms/RoomGraph.h"

namespace roomgraph {

// In:   RoomGraph, AreaGraph, two places
// Out:  Route
// Next: to drive there, or to tell it

/** Where a place is, by the areas and ways of a map. */
struct Whereabouts {
  Point place;       ///< that was asked [m, map frame]
  AreaId area;       ///< that holds it; none for what is in none
  EdgeId edge;       ///< the way next to it; none where none leads there
  double along = 0;  ///< from the source of that way to its place nearest to the asked one [m]
  Point on;          ///< that place; the asked one where there is no way
};

/** In which area a place is, and which way is next to it: of those that run through its area, where
 *  there are any, the one with the place nearest to it; else of those elsewhere, unless the area is
 *  closed all round. O(corners + passages + path points). */
[[nodiscard]] Whereabouts whereIs(const RoomGraph& graph, const AreaGraph& areas, Point place);

/** A shortest way along the graph, and straight to it and from it. */
struct Route {
  Polyline points;                  ///< from the first place to the last [m, map frame]
  double length = 0;                ///< [m]
  double besideWays = 0;            ///< so much of it is straight, to the ways and from them [m]
  double minClearance = 0;          ///< smallest distance to an obstacle that its ways state [m]
  std::vector<PassageId> passages;  ///< which it goes through, in this order
};

/** The shortest way along the graph between two places whose ways have at least this clearance [m];
 *  none where they are not connected so. Dijkstra's algorithm; O(n log n), and for the passages
 *  O(points * passages). */
[[nodiscard]] std::optional<Route> findRoute(const RoomGraph& graph, const AreaGraph& areas,
                                             const Whereabouts& from, const Whereabouts& to,
                                             double minClearance = 0);

}  // namespace roomgraph
