#pragma once
#include "roomgraph/align/NarrowingBand.h"
#include "roomgraph/align/WallMap.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** A map that is made larger about the origin of its frame, and then laid down. */
struct ScaledPose {
  double scale = 1;  ///< of b's places
  Transform2D pose;  ///< a <- b, after that
};

struct FitScaleOptions {
  NarrowingBand band{1.0, 0.2, 12};  ///< around a wall, of what counts
  int maxPoints = 1000;              ///< wall points of a map that are looked up
};

/** What refineAlignment does, with the scale of `b` free as well. Right as long as the scale is
 *  within a few percent, so that walls have their own in reach. O(steps * points). */
ScaledPose fitScale(const WallMap& a, const WallMap& b, const Transform2D& pose,
                    const FitScaleOptions& options);

}  // namespace roomgraph
