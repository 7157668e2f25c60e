#include "drive_office.h"

#include <algorithm>

#include "roomgraph/base/Error.h"
#include "simulate_scans.h"

namespace roomgraph {
namespace {

double lengthOf(const std::vector<Point>& corners) {
  double length = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) length += distance(corners[i - 1], corners[i]);
  return length;
}

}  // namespace

OfficeDrive driveOffice(const GreyMap& office, const std::vector<Point>& corners,
                        const DriveOfficeOptions& options) {
  if (corners.size() < 2) throw UsageError("this office has no room for a robot: use another one");
  OfficeDrive result;
  result.truth = walk(corners, std::max(2, int(lengthOf(corners) / options.metresPerFrame)));
  SimulateScansOptions laser;
  laser.seed = options.seed;
  const auto believed = drift(result.truth, {0, 0, options.turn}, options.drift);
  result.frames = simulateScans(office, result.truth, believed, laser);
  return result;
}

}  // namespace roomgraph
