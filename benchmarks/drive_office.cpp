#include "drive_office.h"

#include <algorithm>

#include "roomgraph/base/Error.h"
#include "roomgraph/geometry/Polyline.h"
#include "simulate_scans.h"

namespace roomgraph {
OfficeDrive driveOffice(const GreyMap& office, const std::vector<Point>& corners,
                        const DriveOfficeOptions& options) {
  if (corners.size() < 2) throw UsageError("this office has no room for a robot: use another one");
  OfficeDrive result;
  result.truth = walk(corners, std::max(2, int(length(corners) / options.metresPerFrame)));
  SimulateScansOptions laser;
  laser.seed = options.seed;
  const auto believed = drift(result.truth, {0, 0, options.turn}, options.drift);
  result.frames = simulateScans(office, result.truth, believed, laser);
  return result;
}

}  // namespace roomgraph
