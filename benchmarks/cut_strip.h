#pragma once

#include "alignment_cases.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/grid/Grid.h"

namespace roomgraph {

/** Two maps that overlap in a strip, and the places of b in it. */
struct CutPair {
  Grid a, b;
  std::vector<Point> places;  ///< free in both [m, frame of b]
};

/** Cuts both maps through the middle of what is free in both, so that the common free space is
 *  how.share of the smaller cut map's. `pose` is the true a <- b. No places where there is no such
 *  strip. */
CutPair cutStrip(const Grid& a, const Grid& b, const Transform2D& pose, const StripCut& how);

}  // namespace roomgraph
