#pragma once
#include "roomgraph/geometry/Polyline.h"

namespace roomgraph {

/** The line with as few of its points as a single pass can find, such that those left out lie about
 *  within `tolerance` of it. Both ends stay. O(n). */
[[nodiscard]] Polyline thinnedLine(const Polyline& line, double tolerance);

}  // namespace roomgraph
