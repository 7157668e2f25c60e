#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/breaks/MapBreak.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** Poses of a run's scans elsewhere [there <- run], in the order of the scans. */
using ScanTrack = std::vector<Transform2D>;

/** A place where a run's own poses jump. */
struct ScanBreak {
  std::size_t scan = 0;    ///< the first one behind the break, or behind its largest step
  std::size_t before = 0;  ///< the last scan ahead of the whole break
  std::size_t behind = 0;  ///< the first one behind the whole
  double rotation = 0;     ///< by which the run turns its map too far from there on [rad]
  double shift = 0;        ///< by which it moves it too far, at the robot's place [m]
};

/** From which on a jump is a break. */
struct FindBreaksOptions {
  double minRotation = kBreakRotation;  ///< [rad]
  double minShift = kBreakShift;        ///< [m]
};

}  // namespace roomgraph
