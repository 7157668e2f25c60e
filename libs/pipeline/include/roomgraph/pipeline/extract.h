#pragma once
#include "roomgraph/pipeline/Stages.h"

namespace roomgraph {

// Paper III, all of it
// In:   GreyMap
// Out:  Stages, with the RoomGraph and the AreaGraph
// Next: graphJson, drawPng, alignMaps

/** The whole way from a map to its room-aware topology graph, one call per section of the paper.
 *  Same map and options give the same result, whatever else runs beside it. An odd map (no free
 *  cell, no obstacle, no room) gives an empty graph and a note that says why.
 *
 *      const Stages stages = extract(loadGrid("office.yaml", {}), {});
 *      double inRooms = 0;  // [m2]
 *      for (const GraphRoom& room : stages.result.rooms)
 *        inRooms += area(room.shape.polygon);
 *
 *  O(n log n) in the number of obstacle cells, O(cells) in the size of the map. */
[[nodiscard]] Stages extract(const GreyMap& map, const ExtractOptions& options);

/** The same in less memory, which counts for large maps: the map goes once its cells are known,
 *  and `voronoi`, `isInside` and `clearEdges`, which are empty, once the topology graph is made. */
[[nodiscard]] Stages extractGraph(GreyMap map, const ExtractOptions& options);

/** The same, where `before` is what extract() made of this map with other options of the steps
 *  behind the Voronoi diagram: grid, obstacles and diagram, which take most of the time, are
 *  taken from it. The options of binarize and thin_obstacles must be those that it was made with.
 */
[[nodiscard]] Stages extractAgain(Stages before, const GreyMap& map, const ExtractOptions& options);

}  // namespace roomgraph
