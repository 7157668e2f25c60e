#pragma once
#include "roomgraph/align/WallMap.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** A map that is made larger about the origin of its frame, and then laid down. */
struct ScaledPose {
  double scale = 1;  ///< of b's places
  Transform2D pose;  ///< a <- b, after that
};

/** What refineAlignment does, with the scale of `b` free as well. Right as long as the scale is
 *  within a few percent, so that walls have their own in reach; `reach`: how far these may lie from
 *  where they belong [m]. O(points). */
ScaledPose fitScale(const WallMap& a, const WallMap& b, const Transform2D& pose,
                    double reach = 1.0);

}  // namespace roomgraph
