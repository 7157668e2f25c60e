#pragma once
#include <optional>
#include <vector>

#include "roomgraph/align/scan_walls.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {

/** A run that has gone less far between two scans has not come back [m]. */
constexpr double kWayRound = 10;

/** The walls of a scan as the robot saw them: what its run has made of its pose is left out. */
struct LocalScan {
  std::vector<WallPoint> walls;  ///< [m, robot frame], in the order of the beams
  std::optional<double> time;    ///< [s]

  static constexpr std::size_t kTelling = 20;  ///< walls that are enough to tell by

  /** Whether it shows enough to be looked for. */
  bool isTelling() const { return walls.size() >= kTelling; }
};

/** Of each scan: where its run has drawn it (run <- robot). */
inline std::vector<Transform2D> drawnPoses(const std::vector<ScanWalls>& scans) {
  return mapped(scans, &ScanWalls::pose);
}

/** Of each scan. O(walls). */
inline std::vector<LocalScan> localScans(const std::vector<ScanWalls>& scans) {
  std::vector<LocalScan> local(scans.size());
  for (std::size_t k = 0; k < scans.size(); ++k) {
    local[k].time = scans[k].time;
    const Motion2D back(scans[k].pose.inverse());
    for (const WallPoint& wall : scans[k].walls)
      local[k].walls.push_back({back(wall.place), back.turned(wall.normal)});
  }
  return local;
}

}  // namespace roomgraph
