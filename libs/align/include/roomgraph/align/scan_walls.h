#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "roomgraph/align/WallPoint.h"
#include "roomgraph/align/scan_axes.h"
#include "roomgraph/geometry/PointSums.h"
#include "roomgraph/scans/Keyframe.h"

namespace roomgraph {

// In:   the scans of a run
// Out:  ScanWalls
// Next: trackScans, addRunNodes, scanDisagreement

/** A scan as walls: what its neighbouring beams met. */
struct ScanWalls {
  std::size_t keyFrame = 0;      ///< number of its key frame, see Keyframe
  Transform2D pose;              ///< run <- robot
  std::vector<WallPoint> walls;  ///< [m, frame of the run]
  PointSums ends;                ///< of all beams [m, robot frame]
  std::optional<ScanAxes> axes;  ///< of those
  std::optional<double> time;    ///< see Keyframe
  std::uint64_t scanId = 0;      ///< see Keyframe

  /** Where it was [m, frame of the run]. */
  [[nodiscard]] Point robot() const { return pose.shift(); }
};

/** Ends of neighbouring beams this near to each other are of one wall, up to 4 m away; farther off
 *  so much more [m]. */
constexpr double kSameSurface = 0.3;

/** Of a scan that is compared with maps; more would tell no more. */
constexpr int kWallsPerScan = 90;

/** At most `maxWalls` walls of each scan, evenly; beams that meet nothing near their neighbours'
 *  are left out. */
[[nodiscard]] std::vector<ScanWalls> scanWalls(const std::vector<Keyframe>& frames,
                                               int maxWalls = kWallsPerScan);

/** The way driven up to each scan [m]. */
[[nodiscard]] std::vector<double> drivenWays(const std::vector<ScanWalls>& scans);

}  // namespace roomgraph
