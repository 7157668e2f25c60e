#pragma once
#include <string>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** A shift from which on a map is broken, if it hardly turns [m]. */
constexpr double kBreakShift = 0.4;

/** A place where a map bends: what lies on one side of it is turned and shifted as a whole. */
struct MapBreak {
  std::string run;      ///< name
  Point place;          ///< [m, site frame]
  double rotation = 0;  ///< of the far side against the near one [rad]
  double shift = 0;     ///< of the far side at `place` [m]
};

}  // namespace roomgraph
