#pragma once
#include <vector>

#include "GraphMatch.h"

namespace roomgraph {

/** Whether two ways may be the same by their lengths [m]. */
bool isSameLength(double a, double b);

/** The ways between matched vertices that both graphs have, by their lengths: edges, one to one,
 *  those of the most equal lengths first; and where two matched vertices have no such edge, their
 *  shortest ways that pass no other matched vertex. Ordered by their ends. */
std::vector<PathMatch> sharedPaths(const TopologyGraph& a, const TopologyGraph& b,
                                   const std::vector<VertexMatch>& vertices);

}  // namespace roomgraph
