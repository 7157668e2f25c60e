#pragma once
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

// Ours
// In:   two maps and a pose
// Out:  what speaks for it and against it
// Next: alignMaps

struct VerifyAlignmentOptions {
  double near = kWallNoise;  ///< how far apart the same wall lies [m], in a good map
  double far = 0.4;          ///< and in a bent one
  int maxPoints = 1000;      ///< wall points of a map that are looked up
};

/** Lengths of wall [m], of both maps together; each side of a wall counts for itself. */
struct AlignmentEvidence {
  double close = 0;         ///< found again, counting by distance against `near`
  double loose = 0;         ///< the same against `far`
  double slightly = 0;      ///< in the other map's free space, more than 0.2 m from its end
  double contradicted = 0;  ///< the same, more than 0.5 m, and not found loosely
  double known = 0;         ///< where the other map knows what is there
  double all = 0;
  double weakest = 0;     ///< of `loose`, what holds the pose in its weakest direction
  double overlap = 0;     ///< share of the smaller free space that is free in both, 0 to 1
  double common = 0;      ///< free in one and free or wall in the other; both ways together [m2]
  double freeOnWall = 0;  ///< share of `common` that is wall in the other, 0 to 1
};

/** Looks up each map's walls in the other, and each map's free space.
 *  O(points). */
AlignmentEvidence verifyAlignment(const WallMap& a, const WallMap& b, const Transform2D& pose,
                                  const VerifyAlignmentOptions& options);

}  // namespace roomgraph
