#include "roomgraph/align/find_scan.h"

#include <cmath>

#include "roomgraph/align/WallFit.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

constexpr std::size_t kFirstLook = 10;  // walls that tell most poses apart

/** The share of walls found, of a part of them and in the rough. */
double roughQuality(const std::vector<WallPoint>& walls, const WallMap& in,
                    const Transform2D& pose) {
  const auto shareOf = [&](std::size_t count) {
    return wallShare(
        count, [&](std::size_t i) { return walls[i]; }, in, pose, kSameWhereBent);
  };
  if (walls.size() > kFirstLook &&
      shareOf(kFirstLook).found < kFairQuality / 2 * double(kFirstLook))
    return 0;
  const WallShare share = shareOf(walls.size());
  return share.known * 3 > share.all ? share.ofKnown(kDoubt / 3) : 0;
}

std::vector<WallPoint> someOf(const std::vector<WallPoint>& walls) {
  std::vector<WallPoint> some;
  const std::size_t stride = roughStride(walls.size());
  for (std::size_t third = 0; third < 3; ++third)  // so that the first ones are spread
    for (std::size_t i = stride * third; i < walls.size(); i += 3 * stride)
      some.push_back(walls[i]);
  return some;
}

}  // namespace

ScanFit fitAt(const LocalScan& scan, const WallMap& in, const Transform2D& pose) {
  const Motion2D forth(pose);
  double sum = 0, known = 0, xx = 0, xy = 0, yy = 0;
  for (const WallPoint& point : scan.walls) {
    const WallLookUp there = lookUp(point, in, forth);
    const double found = there.found(kWallCell);
    const Point normal = there.normal;
    known += there.isKnown, sum += found;
    xx += found * normal.x * normal.x, xy += found * normal.x * normal.y;
    yy += found * normal.y * normal.y;
  }
  ScanFit fit{pose, 0, 0, 0, 0};
  if (known <= 0) return fit;
  fit.quality = sum / (known + kDoubt);
  fit.score = sum - 0.5 * known;
  fit.known = known / double(scan.walls.size());
  const double trace = xx + yy;
  if (trace > 0) fit.hold = 0.5 - std::hypot((xx - yy) / 2, xy) / trace;
  return fit;
}

ScanFit fitNear(const LocalScan& scan, const WallMap& in, const Transform2D& start) {
  return fitAt(scan, in, fittedPose(start, {}, kScanBand, [&](WallFit& fit, int) {
                 for (const WallPoint& wall : scan.walls) fit.add(wall, in);
               }));
}

std::vector<ScanFit> findScan(const LocalScan& scan, const WallMap& in, const Transform2D& around,
                              const PoseTolerance& window, std::size_t count) {
  const std::vector<WallPoint> some = someOf(scan.walls);
  std::vector<std::pair<double, Transform2D>> tries;
  const int turns = int(std::ceil(std::min(window.turn, M_PI) / kSameScanStart.turn));
  const int steps = int(std::ceil(window.place / kSameWhereBent));
  for (int t = -turns; t <= turns; ++t)
    for (int x = -steps; x <= steps; ++x)
      for (int y = -steps; y <= steps; ++y) {
        const Transform2D pose{around.x + x * kSameWhereBent, around.y + y * kSameWhereBent,
                               wrappedAngle(around.phi + t * kSameScanStart.turn)};
        const double quality = roughQuality(some, in, pose);
        if (quality > kFairQuality) tries.emplace_back(quality, pose);
      }
  const std::size_t wanted = std::min(tries.size(), 30 * kTries);
  std::partial_sort(tries.begin(), tries.begin() + std::ptrdiff_t(wanted), tries.end(),
                    [](const auto& l, const auto& r) { return l.first > r.first; });
  std::vector<Transform2D> starts;
  for (std::size_t i = 0; i < wanted && starts.size() < kTries; ++i)
    if (!isNearAny(starts, tries[i].second, {}, kSameScanStart)) starts.push_back(tries[i].second);
  auto fits = mapped(starts, [&](const Transform2D& start) { return fitNear(scan, in, start); });
  sortDownBy(fits, &ScanFit::quality);
  return distinctBest(fits, count, [](const ScanFit& l, const ScanFit& r) {
    return areNear(l.pose, r.pose, {}, kSameScanAnswer);
  });
}

}  // namespace roomgraph
