#pragma once
#include <optional>
#include <vector>

#include "roomgraph/grid/GridFrame.h"
#include "roomgraph/rooms/RoomGraph.h"
#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

// Ours, beside the paper's measure
// In:   two graphs in one frame
// Out:  which vertex is which, and which room
// Next: stability

struct MatchedVertices {
  VertexId base, other;
  double distance = 0;  ///< [m]
};

/** Pairs each vertex of `base` with at most one of `other` and the other way round, none of them
 *  farther apart than `maxDistance` [m]. The nearest two of all are a pair, then the nearest two of
 *  those that are left, and so on: the one matching in which no two vertices are both nearer to
 *  each other than to their partners. So it is the same from both sides. Equal distances go by
 *  vertex numbers, `base` first. Pairs are ordered by distance. O(k log k) for k pairs in reach,
 *  besides sorting the vertices. */
std::vector<MatchedVertices> matchVertices(const TopologyGraph& base, const TopologyGraph& other,
                                           double maxDistance);

/** What a matching says in four numbers. */
struct VertexAgreement {
  std::optional<double> median;          ///< distance of the pairs [m]; none where there is no pair
  std::optional<double> percentile90;    ///< of the pairs, the same
  std::optional<double> unmatchedBase;   ///< share, 0 to 1; none for an empty graph
  std::optional<double> unmatchedOther;  ///< share, 0 to 1; none for an empty graph
};

/** `pairs` must be ordered by distance. Percentiles are read between the two nearest pairs. */
VertexAgreement vertexAgreement(const std::vector<MatchedVertices>& pairs, std::size_t baseCount,
                                std::size_t otherCount);

// Paper IV-C
/** The paper's measure: the mean over the vertices of `base` of the distance to the nearest vertex
 *  of `other` [m]. It is one-sided: vertices that only `other` has cost nothing, and one vertex of
 *  `other` may serve many of `base`, so dense graphs fare well. matchVertices() is neither.
 *  None where one of the graphs is empty. O(vertices * vertices). */
std::optional<double> nearestVertices(const TopologyGraph& base, const TopologyGraph& other);

struct MatchedRooms {
  RoomId base, other;
  double overlap = 0;  ///< intersection over union, more than a half
};

/** Finds each room of `base` again in `other`: two rooms are the same where their common area is
 *  more than half of that which they cover together. No room can be the same as two others as long
 *  as the rooms of a graph do not overlap. Areas are counted in cells of `frame` whose centre lies
 *  in a room's polygon; a room without any is not found. Ordered by base room. O(cells). */
std::vector<MatchedRooms> matchRooms(const std::vector<GraphRoom>& base,
                                     const std::vector<GraphRoom>& other, const GridFrame& frame);

}  // namespace roomgraph
