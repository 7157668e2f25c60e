#pragma once
#include <vector>

#include "roomgraph/align/WallMap.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

// In:   two WallMap
// Out:  poses worth a closer look
// Next: refineAlignment, verifyAlignment

/** How much a search for poses may cost. */
struct SearchEffort {
  double cell = 0;   ///< of the search [m]; larger for large maps
  int points = 0;    ///< wall points of a map that are looked up, at most 800 (sums of 16 bits)
  int perAngle = 0;  ///< places kept for one angle
  int poses = 0;     ///< kept in all
  int closer = 0;    ///< of these, that are looked at once more
  int close = 0;     ///< of those, that are looked at closely
};

constexpr SearchEffort kFullSearch{0.25, 500, 30, 2500, 120, 60};
/** Good enough to tell which of several scales is right. */
constexpr SearchEffort kQuickSearch{0.3, 300, 6, 200, 40, 12};

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
                                                     const SearchEffort& effort = kFullSearch);

}  // namespace roomgraph
