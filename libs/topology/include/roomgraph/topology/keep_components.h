#pragma once
#include <functional>
#include <string>

#include "roomgraph/base/Notes.h"
#include "roomgraph/base/Options.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

// Paper III-A, the end
// In:   TopologyGraph, and where the rooms are
// Out:  TopologyGraph
// Next: borderVertices

struct KeepComponentsOptions {
  std::string which = "with_rooms";  ///< largest, with_rooms or all
  double minLength = 1.0;            ///< of the paths of those that only `all` keeps [m]
};
void describe(KeepComponentsOptions& options, FieldTable& table);

using RoomAt = std::function<RoomId(Point)>;  ///< the room at a place, or none [m]

/** Keeps the connected component with the largest total path length (where all are 0, the one with
 *  the widest place); unless only that is wanted, also each other one that leads into a room that
 *  no longer one leads into, as behind a closed door; and with `all`, those from `minLength` up.
 *  What is dropped is told in `notes` (code "component_dropped"). O(n), and of the same order of
 *  calls to `roomAt` where there are several components. */
[[nodiscard]] TopologyGraph keepComponents(TopologyGraph graph, const RoomAt& roomAt,
                                           const KeepComponentsOptions& options, Notes& notes);

}  // namespace roomgraph
