#pragma once
#include <algorithm>
#include <cstddef>

#include "roomgraph/base/PairTable.h"

namespace roomgraph {

/** Wall points below which what two maps have in common tells nothing for sure. */
constexpr double kFewestWalls = 300;

/** Fewer vertices, paths, scans or square metres tell nothing for sure. */
constexpr double kFewestThings = 10;

/** Fewer other runs can not outvote one that is wrong. */
constexpr std::size_t kFewestOthers = 2;

/** How far one map bends away from another, see FollowedWalls. */
struct PairBend {
  double bend = 0;   ///< root mean square [m]
  double share = 0;  ///< of the walls it was seen on, 0 to 1; 0 where nothing could be compared
  double walls = 0;  ///< wall points it was seen on
  bool areIdentical = false;  ///< the maps are the same
  bool areEdits = false;      ///< of one picture, which is one drive
  double misfit = 0;          ///< the larger one of both ways, see FollowedWalls [m]
  double agreement = 1;       ///< the smaller bend of both ways over `bend`; 1: not in doubt
};

using PairBends = PairTable<PairBend>;

/** The largest share of its walls that a run has in common with another. */
inline double mostShare(const PairBends& bends, std::size_t run) {
  double most = 0;
  for (const std::size_t j : bends.othersOf(run)) most = std::max(most, bends(run, j).share);
  return most;
}

}  // namespace roomgraph
