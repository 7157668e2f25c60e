#include "roomgraph/breaks/track_scans.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/align/WallFit.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/align/nearest_wall.h"

namespace roomgraph {
namespace {

constexpr std::size_t kMinWalls = 20;
constexpr double kDoubt = 5;  // walls that speak against each pose beforehand

double qualityAt(const ScanWalls& scan, const MapForAlignment& in, const Transform2D& pose,
                 const TrackScansOptions& options) {
  const Motion2D forth(pose);
  double sum = 0, known = 0;
  for (const WallPoint& point : scan.walls) {
    const Point at = forth(point.place);
    const std::size_t cell = cellIndexAt(in.frame, at);
    if (cell >= in.states.size() || in.states[cell] == State::unknown) continue;
    ++known;
    if (const WallPoint* wall = nearestWall(in, cell, forth.turned(point.normal)))
      sum += 1 / (1 + squaredNorm(wall->place - at) / (options.near * options.near));
  }
  return known >= double(kMinWalls) && known > 0.5 * double(scan.walls.size())
             ? sum / (known + kDoubt)
             : 0;
}

class Tracker {
 public:
  Tracker(const WallPatches& patches, const FollowedWalls& followed, const MapForAlignment& in,
          const TrackScansOptions& options)
      : patches_(patches), followed_(followed), in_(in), options_(options) {}

  std::optional<Transform2D> track(const ScanWalls& scan) {
    if (scan.walls.size() < kMinWalls) return std::nullopt;
    double best = options_.minQuality;
    std::optional<Transform2D> found;
    const auto tryFrom = [&](const Transform2D& start, double margin) {
      const Transform2D pose = fitted(scan, start);
      const double quality = qualityAt(scan, in_, pose, options_);
      if (quality > best + margin) best = quality, found = pose;
    };
    if (last_) tryFrom(*last_, 0);
    if (best < options_.sureQuality)
      for (const Transform2D& pose : posesNear(scan.at)) tryFrom(pose, last_ ? options_.margin : 0);
    if (found) last_ = found;
    return found;
  }

 private:
  Transform2D fitted(const ScanWalls& scan, Transform2D pose) const {
    for (int i = 0; i < options_.iterations; ++i) {
      const double share = double(i) / std::max(1, options_.iterations - 1);
      WallFit fit(pose, scan.at,
                  options_.firstWidth * std::pow(options_.lastWidth / options_.firstWidth, share));
      for (const WallPoint& point : scan.walls) fit.add(point, in_);
      if (!fit.isEnough()) break;
      pose = fit.improved();
    }
    return pose;
  }

  /** What was followed near a place, alike poses once. */
  std::vector<Transform2D> posesNear(Point at) const {
    std::vector<Transform2D> poses;
    for (const FollowedPatch& f : followed_.patches) {
      if (distance(patches_[f.patch].middle, at) > options_.reach) continue;
      const bool isKnown = std::any_of(poses.begin(), poses.end(), [&](const Transform2D& pose) {
        return areNear(pose, f.pose, at, kSameFit);
      });
      if (!isKnown) poses.push_back(f.pose);
    }
    return poses;
  }

  const WallPatches& patches_;
  const FollowedWalls& followed_;
  const MapForAlignment& in_;
  const TrackScansOptions& options_;
  std::optional<Transform2D> last_;
};

}  // namespace

std::vector<std::optional<Transform2D>> trackScans(const std::vector<ScanWalls>& scans,
                                                   const WallPatches& patches,
                                                   const FollowedWalls& followed,
                                                   const MapForAlignment& in,
                                                   const TrackScansOptions& options) {
  Tracker tracker(patches, followed, in, options);
  std::vector<std::optional<Transform2D>> poses;
  for (const ScanWalls& scan : scans) poses.push_back(tracker.track(scan));
  return poses;
}

}  // namespace roomgraph
