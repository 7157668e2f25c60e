#include "extend_errors.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fitted_consensus.h"
#include "roomgraph/align/WallFit.h"
#include "roomgraph/align/find_scan.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/align/wall_share.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/relate/PairBend.h"

namespace roomgraph {
namespace {

constexpr double kOfTheGap = 1.0 / 3;  // that the scales of a set may differ by

/** How long a run has drawn 1 m. */
struct DrawnScale {
  RunId run;
  double scale = 1;
};

/** Where three scales or more, ascending, fall into two sets: the place of the first of the larger
 *  ones. */
std::optional<std::size_t> splitOf(const std::vector<DrawnScale>& scales) {
  const auto gapBefore = [&](std::size_t i) { return scales[i].scale - scales[i - 1].scale; };
  std::size_t split = 1;
  for (std::size_t i = 2; i < scales.size(); ++i)
    if (gapBefore(i) > gapBefore(split)) split = i;
  const double gap = gapBefore(split);
  const double within = std::max(scales[split - 1].scale - scales.front().scale,
                                 scales.back().scale - scales[split].scale);
  const std::size_t smaller = std::min(split, scales.size() - split);
  if (gap < fitted::kUsualStretch || within > kOfTheGap * gap) return std::nullopt;
  if (smaller == 1 && scales.size() > kFewestOthers + 1) return std::nullopt;
  return split;
}

double meanOf(const std::vector<DrawnScale>& scales, std::size_t first, std::size_t end) {
  double sum = 0;
  for (std::size_t i = first; i < end; ++i) sum += scales[i].scale;
  return sum / double(end - first);
}

/** Lets the interval hold the error by either scale, with the same margins: without what the own
 *  scale adds, and with what the other's would. What remains may point the same way, or across. */
void extend(MapError& error, double ownSet, double otherSet) {
  const double added = std::abs(error.scale - 1) * error.reach;
  const double along = std::max(0.0, error.error - added);
  const double across = std::sqrt(std::max(0.0, error.error * error.error - added * added));
  const double below = std::max(0.0, error.error - error.low);
  const double above = std::max(0.0, error.high - error.error);
  const double ifRight = std::hypot(along, std::abs(error.scale - ownSet) * error.reach);
  const double ifOther = std::hypot(across, std::abs(error.scale - otherSet) * error.reach);
  error.low = std::min(error.low, std::max(0.0, ifRight - below));
  error.high = std::max(error.high, ifOther + above);
}

constexpr double kMostSquared = 0.25;  // of one scan; beyond, it is a break [m^2]

using Walls = std::vector<WallPoint>;
using Correction = std::optional<Transform2D>;

/** Where a wall belongs that the scan `onto` has, too, whose walls are by x: the nearest that faces
 *  alike, moved along itself as far as there is none between it and the next. */
std::optional<WallPoint> sameWall(const WallPoint& wall, const Walls& onto) {
  constexpr double gap = 2 * kSameWall;  // between walls of one scan, along them
  std::optional<WallPoint> nearest;
  double least = WallMap::kReach * WallMap::kReach;
  const double low = wall.place.x - WallMap::kReach, high = wall.place.x + WallMap::kReach;
  auto other = std::lower_bound(onto.begin(), onto.end(), low,
                                [](const WallPoint& it, double x) { return it.place.x < x; });
  for (; other != onto.end() && other->place.x <= high; ++other) {
    const Point off = wall.place - other->place;
    if (squaredNorm(off) >= WallMap::kReach * WallMap::kReach) continue;
    if (dot(other->normal, wall.normal) < kFacesAlike) continue;
    const Point side{-other->normal.y, other->normal.x};
    const WallPoint there{other->place + std::clamp(dot(off, side), -gap, gap) * side,
                          other->normal};
    const double apart = squaredNorm(wall.place - there.place);
    if (apart < least) least = apart, nearest = there;
  }
  return nearest;
}

/** The motion that lays a scan onto another; none where they hardly show the same. */
Correction laidOnto(Walls onto, const Walls& scan, Point robot) {
  sortBy(onto, [](const WallPoint& wall) { return wall.place.x; });
  const auto moved = [&](const WallPoint& wall, const Motion2D& by) {
    return WallPoint{by(wall.place), by.turned(wall.normal)};
  };
  const Transform2D found = fittedPose({}, robot, kScanBand, [&](WallFit& fit, int) {
    for (const WallPoint& wall : scan) {
      const WallPoint there = moved(wall, fit.forth());
      if (const auto same = sameWall(there, onto)) fit.add(there.place, *same);
    }
  });
  const auto met = countIf(scan, [&, by = Motion2D(found)](const WallPoint& wall) {
    const WallPoint there = moved(wall, by);
    const auto same = sameWall(there, onto);
    return same && distance(same->place, there.place) < kSameWall;
  });
  if (met < kFewestPoints || double(met) < kMajority * double(scan.size())) return std::nullopt;
  return found;
}

/** How the step to a scan is off by what the two show: the mean of laying either onto the other,
 *  where both come to the same. One alone is drawn to what only one of them shows. */
Correction correctionOf(const ScanWalls& before, const ScanWalls& scan) {
  const Correction forth = laidOnto(before.walls, scan.walls, scan.robot());
  if (!forth) return std::nullopt;
  const Correction back = laidOnto(scan.walls, before.walls, before.robot());
  if (!back) return std::nullopt;
  const Transform2D other = back->inverse();
  if (!areNear(*forth, other, scan.robot(), kSameScanAnswer)) return std::nullopt;
  const Point middle = midpoint((*forth)(scan.robot()), other(scan.robot()));
  return carrying(scan.robot(), middle, (forth->phi + other.phi) / 2);
}

/** Squared displacement of a scan on its own, by the corrections of the steps to it and behind it:
 *  what is common to both, the other way round. */
double squaredAlone(const Walls& walls, const Transform2D& to, const Transform2D& behind) {
  double sum = 0;
  for (const WallPoint& wall : walls)
    sum -= dot(to(wall.place) - wall.place, wall.normal) *
           dot(behind(wall.place) - wall.place, wall.normal);
  // Walls tell what is across them, which is half of it.
  return std::clamp(2 * sum / double(walls.size()), -kMostSquared, kMostSquared);
}

}  // namespace

void tellScales(Consensus& consensus) {
  std::vector<DrawnScale> scales;
  for (const RunId run : consensus.graph.runs.ids()) {
    const MapError& error = consensus.errors[run];
    const double scale = 1 / consensus.graph.runs[run].stretch;
    if (consensus.graph.showsStretch(run) && error.seen > 0 && error.confirmed >= kMajority)
      scales.push_back({run, scale});
  }
  if (!consensus.graph.reference && scales.size() <= kFewestOthers) return;
  for (const DrawnScale& one : scales) consensus.errors[one.run].scale = one.scale;
  sortBy(scales, &DrawnScale::scale);
  if (consensus.graph.reference) return;
  const auto split = splitOf(scales);
  if (!split) return;
  const double small = meanOf(scales, 0, *split), large = meanOf(scales, *split, scales.size());
  for (std::size_t i = 0; i < scales.size(); ++i) {
    MapError& error = consensus.errors[scales[i].run];
    const bool isLarge = i >= *split;
    error.scaleSet = isLarge ? ScaleSet::larger : ScaleSet::smaller;
    extend(error, isLarge ? large : small, isLarge ? small : large);
  }
}

ScanJitter scanJitter(const std::vector<ScanWalls>& scans, const std::vector<Transform2D>& poses) {
  std::vector<Correction> corrections(scans.size());
  for (std::size_t k = 1; k < scans.size(); ++k)
    corrections[k] = correctionOf(scans[k - 1], scans[k]);
  const auto taken = [&](std::size_t k) {
    return scans[k - 1].pose * poses[k - 1].inverse() * poses[k] * scans[k].pose.inverse();
  };
  double drawn = 0, left = 0, count = 0;
  for (std::size_t k = 1; k + 1 < scans.size(); ++k) {
    if (!corrections[k] || !corrections[k + 1]) continue;
    const double alone = squaredAlone(scans[k].walls, *corrections[k], *corrections[k + 1]);
    drawn += alone, ++count;
    left += alone - squaredAlone(scans[k].walls, taken(k), taken(k + 1));
  }
  if (count < kFewestThings) return {};
  return {std::sqrt(std::max(0.0, drawn / count)), std::sqrt(std::max(0.0, left / count))};
}

void addJitter(Consensus& consensus, const Site& site) {
  for (const RunId run : consensus.graph.runs.ids()) {
    const std::vector<ScanWalls>& scans = site.runs[consensus.siteRuns[run]]->scans;
    if (run == consensus.graph.reference || scans.empty()) continue;
    const ScanJitter jitter = scanJitter(scans, consensus.posesOf(consensus.siteRuns[run]));
    if (jitter.drawn <= fitted::kUsualJitter) continue;
    MapError& error = consensus.errors[run];
    error.jitter = jitter.drawn;
    if (jitter.left <= fitted::kUsualJitter) continue;
    const double more =
        std::sqrt(jitter.left * jitter.left - fitted::kUsualJitter * fitted::kUsualJitter);
    error.error = std::hypot(error.error, more);
    error.low = std::hypot(error.low, more / fitted::kJitterFactor);
    error.high = std::hypot(error.high, more * fitted::kJitterFactor);
    for (double& each : error.errors) each = std::hypot(each, more);
  }
}

}  // namespace roomgraph
