#pragma once
#include <optional>

#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

// Paper IV-C
// In:   two TopologyGraphs in one frame
// Out:  how far apart they are
// Next: stability

/** The paper's measure: the mean over the vertices of `base` of the distance to the nearest vertex
 *  of `other` [m]. It is one-sided: vertices that only `other` has cost nothing, and one vertex of
 *  `other` may serve many of `base`, so dense graphs fare well. matchVertices() is neither.
 *  None where one of the graphs is empty. O(vertices * vertices). */
std::optional<double> nearestVertices(const TopologyGraph& base, const TopologyGraph& other);

}  // namespace roomgraph
