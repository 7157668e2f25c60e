#pragma once
#include <array>
#include <vector>

#include "roomgraph/geometry/Polygon.h"

namespace roomgraph {

using Triangle = std::array<Point, 3>;

/** Triangles that cover the polygon without its holes and do not overlap; none for a polygon
 *  without area. Rings may touch. O(n log n) for common polygons. */
std::vector<Triangle> triangulate(const Polygon& polygon);

}  // namespace roomgraph
