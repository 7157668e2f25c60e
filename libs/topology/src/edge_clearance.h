#pragma once
#include <algorithm>

#include "roomgraph/topology/VoronoiGraph.h"

namespace roomgraph {

/** Smallest distance to the obstacles p and q along the edge a–b, as far from the one as from the
 *  other. */
inline double edgeClearance(Point p, Point q, const VoronoiVertex& a, const VoronoiVertex& b) {
  const double along = dot(midpoint(p, q) - a.place, b.place - a.place);
  const bool passesBetween = along > 0 && along < squaredNorm(b.place - a.place);
  return passesBetween ? distance(p, q) / 2 : std::min(a.clearance, b.clearance);
}

/** The same along the ray from `a` to infinity that has p on its left and q on its right. */
inline double rayClearance(Point p, Point q, const VoronoiVertex& a) {
  const Point ahead = toLeft(q - p);
  return dot(midpoint(p, q) - a.place, ahead) > 0 ? distance(p, q) / 2 : a.clearance;
}

}  // namespace roomgraph
