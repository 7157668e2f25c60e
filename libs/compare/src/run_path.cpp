#include "run_path.h"

namespace roomgraph {

std::vector<PathPose> runPath(const Run& run, const Transform2D& pose, const MapError& error) {
  const bool hasErrors = error.errors.size() == run.scans.size();
  const auto isConfirmed = [&](std::size_t k) {
    return error.isConfirmed.empty() || error.isConfirmed[k];
  };
  std::vector<PathPose> path;
  for (std::size_t k = 0; k < run.scans.size(); ++k) {
    const ScanWalls& scan = run.scans[k];
    path.push_back({scan.keyFrame, scan.time, pose * scan.pose,
                    hasErrors && isConfirmed(k) ? std::optional(error.errors[k]) : std::nullopt});
  }
  return path;
}

}  // namespace roomgraph
