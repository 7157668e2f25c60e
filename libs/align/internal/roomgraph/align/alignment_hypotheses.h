#pragma once
#include <vector>

#include "roomgraph/align/WallMap.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

// Ours
// In:   two WallMap
// Out:  poses worth a closer look
// Next: refineAlignment, verifyAlignment

struct AlignmentHypothesesOptions {
  double cell = 0.25;      ///< of the search [m]; larger for maps of more than maxCells
  int maxCells = 140;      ///< of the search, across a map
  double angleStep = 2;    ///< [deg]
  double turnShare = 0.4;  ///< turns that line up fewer of the walls than this are not tried
  int maxPoints = 500;  ///< wall points of a map that are looked up, at most 800 (sums of 16 bits)
  int perAngle = 30;    ///< places kept for one angle
  int count = 2500;     ///< poses kept in all
};

struct AlignmentHypothesis {
  Transform2D pose;  ///< a <- b
  int score = 0;     ///< of the search; only for comparison within one pair
};

/** Where `b` might lie in `a`: all turns that make walls face the same way, all shifts. The walls
 *  of each map are laid over the other: points for a wall near by that faces the same way, a point
 *  off for each wall in the middle of the other's free space. Local maxima of that sum over both
 *  shift and turn, best first; ties by turn, then by shift. Exact in integers. Empty where a map
 *  has no walls. O(turns * points * cells). */
std::vector<AlignmentHypothesis> alignmentHypotheses(const WallMap& a, const WallMap& b,
                                                     const AlignmentHypothesesOptions& options);

}  // namespace roomgraph
