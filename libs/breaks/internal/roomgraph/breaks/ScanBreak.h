#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "roomgraph/breaks/MapBreak.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** Poses of a run's scans elsewhere [there <- run], in the order of the scans; none where a scan
 *  was not found. */
using ScanTrack = std::vector<std::optional<Transform2D>>;

/** A place where a run's own poses jump. */
struct ScanBreak {
  std::size_t scan = 0;    ///< the first one behind the break, or behind its largest step
  std::size_t before = 0;  ///< the last scan ahead of the whole break
  std::size_t behind = 0;  ///< the first one behind the whole
  double rotation = 0;     ///< by which the run turns its map too far from there on [rad]
  double shift = 0;        ///< by which it moves it too far, at the robot's place [m]
};

struct FindBreaksOptions {
  double minRotation = kBreakRotation;   ///< [rad]
  double minShift = kBreakShift;         ///< [m]
  double outlier = 4;                    ///< times the 95th percentile of the run's other steps
  double quiet = 0.4;                    ///< share of the jump that the steps around it may reach
  std::size_t window = 5;                ///< scans on either side that must be quiet
  std::size_t maxGap = 3;                ///< scans from one that was found to the next
  double wideRotation = kApartRotation;  ///< a turn that is a break in any run [rad]
  double wideShift = kApartShift;        ///< a shift that is one [m]
  std::size_t wideSteps = 4;             ///< scans in which it may come about
};

}  // namespace roomgraph
