#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

/** A vertex of a, and the one of b that is the same place. */
struct VertexMatch {
  VertexId a, b;
  double distance = 0;  ///< mean of both ways, by the poses of the walls near by [m]
};

/** A way that both graphs have: one edge, or several through vertices that are not matched. */
struct PathMatch {
  std::size_t from = 0, to = 0;         ///< of GraphMatch::vertices; from <= to
  std::vector<HalfEdgeId> a, b;         ///< of each graph, in order
  double lengthInA = 0, lengthInB = 0;  ///< [m]
};

struct GraphMatch {
  std::vector<VertexMatch> vertices;      ///< by a
  std::vector<PathMatch> paths;           ///< by from, then to
  double sharedInA = 0, sharedInB = 0;    ///< length of all edges that are part of a path [m]
  double overallInA = 0, overallInB = 0;  ///< length of all edges [m]
};

struct MatchGraphsOptions {
  double reach = 5;           ///< of a patch whose pose places a vertex [m]
  double maxDistance = 1;     ///< of vertices that are matched by their place [m]
  double maxGrown = 1.5;      ///< of neighbours of matched vertices [m]
  double maxUnlike = 0.5;     ///< of vertices that neither look alike nor have matched ways [m]
  double clearance = 0.3;     ///< by which clearances of vertices may differ that look alike [m]
  double lengthSlack = 0.5;   ///< by which lengths of one way may always differ [m]
  double lengthShare = 0.25;  ///< and this share of the longer one
  double maxPathLength = 20;  ///< of a way through vertices that are not matched [m]
};

}  // namespace roomgraph
