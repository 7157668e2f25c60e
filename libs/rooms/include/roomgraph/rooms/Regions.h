#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "roomgraph/topology/VoronoiGraph.h"

namespace roomgraph {

/** What the inside is split into, rooms, pieces of corridor and half-seen space: which Voronoi
 *  vertices, and so which Delaunay faces, make up which region. */
struct Regions {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();  ///< no region

  std::vector<std::uint32_t> regionOf;  ///< per Voronoi vertex; kNone where it is in no region
  std::uint32_t roomCount = 0;          ///< the regions below this are rooms
  std::uint32_t seenCount = 0;          ///< the others, below this, are pieces of corridor
  std::uint32_t count = 0;              ///< the others, below this, are half seen
  /** Per region, how much of what bounds it is wall, beside the mean of the map, from 0 to 1; empty
   *  where nobody looked at walls. */
  std::vector<double> seen;
  /** Faces of one room are parted where less than this lies between them and an obstacle [m]. */
  double radius = 0;

  [[nodiscard]] std::uint32_t of(std::uint32_t vertex) const {
    return vertex == VoronoiEdge::kNoVertex ? kNone : regionOf[vertex];
  }
};

}  // namespace roomgraph
