#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** Widths, and lengths of ways, that differ by less than this share are equal: rounding must not
 *  decide. Cells make passages of just one width common. */
constexpr double kSameWidth = 1e-9;

/** A place that is equally near to three or more obstacles, its nearest ones. */
struct VoronoiVertex {
  Point place;           ///< [m, map frame]
  double clearance = 0;  ///< distance to those obstacles [m]
};

/** The places between two vertices that are equally near to two obstacles, their nearest ones. */
struct VoronoiEdge {
  /** Stands for the end of an edge that runs to infinity. */
  static constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t source = kNoVertex, target = kNoVertex;  ///< vertices; only target may be kNoVertex
  /** The two obstacles, as seen when going from source to target. */
  std::uint32_t left = 0, right = 0;
  double minClearance = 0;  ///< smallest distance to an obstacle along the edge [m]

  [[nodiscard]] bool isInfinite() const { return target == kNoVertex; }  ///< it has one end only
};

/** The Voronoi diagram of the obstacles as a graph; its dual is their Delaunay triangulation.
 *  Where more than three obstacles lie on one circle there is one vertex, so that the graph does
 *  not depend on the map's pose. Edges between two infinite ends (all obstacles on one line) are
 *  left out. */
struct VoronoiGraph {
  std::vector<Point> obstacles;         ///< [m, map frame]
  std::vector<VoronoiVertex> vertices;  ///< places of equal distance to three obstacles or more
  std::vector<VoronoiEdge> edges;       ///< between them
};

}  // namespace roomgraph
