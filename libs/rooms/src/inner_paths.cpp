#include "roomgraph/rooms/inner_paths.h"

#include "place_on_paths.h"
#include "roomgraph/topology/shortest_ways.h"

namespace roomgraph {

InnerPaths innerPaths(const TopologyGraph& graph, const std::vector<EdgeId>& edges,
                      const std::vector<VertexId>& ends, Point center, double minClearance) {
  const PlaceOnPath start = placeOnPaths(graph, edges, center, minClearance);
  const Path& startPath = graph.edge(start.edge).path;
  const ShortestWays ways(graph, edges, start);
  InnerPaths result;
  result.center = placeOn(startPath, start.along);
  result.clearance = clearanceAt(startPath, start.along);
  for (const VertexId end : ends) result.paths.push_back(ways.pathTo(end));
  return result;
}

}  // namespace roomgraph
