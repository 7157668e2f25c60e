#pragma once
#include "roomgraph/align/Look.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

// In:   two maps and a pose
// Out:  what speaks for it and against it
// Next: alignMaps

/** Lengths of wall [m], of both maps together; each side of a wall counts for itself. */
struct AlignmentEvidence {
  double close = 0;         ///< found again, as far apart as the same wall lies in a good map
  double loose = 0;         ///< the same in a bent one
  double slightly = 0;      ///< in the other map's free space, more than 0.2 m from its end
  double contradicted = 0;  ///< the same, more than 0.5 m, and not found loosely
  double known = 0;         ///< where the other map knows what is there
  double all = 0;
  double weakest = 0;     ///< of `loose`, what holds the pose in its weakest direction
  double overlap = 0;     ///< share of the smaller free space that is free in both, 0 to 1
  double common = 0;      ///< free in one and free or wall in the other; both ways together [m2]
  double freeOnWall = 0;  ///< share of `common` that is wall in the other, 0 to 1
};

/** Looks up each map's walls in the other, and each map's free space. O(points). */
AlignmentEvidence verifyAlignment(const WallMap& a, const WallMap& b, const Transform2D& pose,
                                  const Look& look = kCloseLook);

}  // namespace roomgraph
