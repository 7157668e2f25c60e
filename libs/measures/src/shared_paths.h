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

/** Whether two ways may be the same by their lengths [m]. */
bool isSameLength(double a, double b);

/** The ways between matched vertices that both graphs have, by their lengths: edges, one to one,
 *  those of the most equal lengths first; and where two matched vertices have no such edge, their
 *  shortest ways that pass no other matched vertex. Ordered by their ends. */
std::vector<PathMatch> sharedPaths(const TopologyGraph& a, const TopologyGraph& b,
                                   const std::vector<VertexMatch>& vertices);

}  // namespace roomgraph
