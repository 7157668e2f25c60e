#include "roomgraph/align/scan_walls.h"

#include <algorithm>
#include <utility>

namespace roomgraph {
namespace {

constexpr double kSurfaceRange = 4;

std::optional<WallPoint> wallOf(const Keyframe& frame, std::size_t i) {
  if (i == 0 || i + 1 >= frame.ends.size()) return std::nullopt;
  const Point end = frame.ends[i];
  const Point along = frame.ends[i + 1] - frame.ends[i - 1];
  const double gap = kSameSurface * std::max(1.0, norm(end) / kSurfaceRange);
  if (norm(along) < 1e-6 || norm(along) > 2 * gap) return std::nullopt;
  Point normal = (1 / norm(along)) * toLeft(along);
  if (dot(normal, end) > 0) normal = -1.0 * normal;  // towards the robot
  const Point out = turned(normal, frame.pose.phi);
  return WallPoint{frame.pose(end), out};
}

}  // namespace

std::vector<ScanWalls> scanWalls(const std::vector<Keyframe>& frames, int maxWalls) {
  std::vector<ScanWalls> scans;
  for (const Keyframe& frame : frames) {
    ScanWalls scan;
    scan.keyFrame = frame.number;
    scan.pose = frame.pose, scan.time = frame.time, scan.scanId = frame.scanId;
    for (const Point end : frame.ends) scan.ends.add(end);
    scan.axes = scanAxes(frame.ends);
    const std::size_t step = std::max<std::size_t>(1, frame.ends.size() / std::size_t(maxWalls));
    for (std::size_t i = step / 2; i < frame.ends.size(); i += step)
      if (const auto wall = wallOf(frame, i)) scan.walls.push_back(*wall);
    scans.push_back(std::move(scan));
  }
  return scans;
}

std::vector<double> drivenWays(const std::vector<ScanWalls>& scans) {
  std::vector<double> ways(scans.size());
  for (std::size_t k = 1; k < scans.size(); ++k)
    ways[k] = ways[k - 1] + distance(scans[k - 1].robot(), scans[k].robot());
  return ways;
}

}  // namespace roomgraph
