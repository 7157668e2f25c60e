#include "roomgraph/align/step_hold.h"

#include <algorithm>

#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

constexpr double kInCommon = 0.15;  // of scans that follow each other, at least

/** The share of a scan's walls that another scan of its run has, too, where the run has drawn both.
 *  1 for a scan without walls. O(walls^2). */
double commonWalls(const ScanWalls& other, const ScanWalls& scan) {
  const auto isThere = [&](const WallPoint& wall) {
    return anyOf(other.walls, [&](const WallPoint& one) {
      return squaredNorm(one.place - wall.place) < kSameWall * kSameWall &&
             dot(one.normal, wall.normal) > kFacesAlike;
    });
  };
  const auto count = countIf(scan.walls, isThere);
  return scan.walls.empty() ? 1 : double(count) / double(scan.walls.size());
}

}  // namespace

double stepHold(const std::vector<ScanWalls>& scans, std::size_t k) {
  if (k == 0 || k >= scans.size()) return 1;
  double common = commonWalls(scans[k - 1], scans[k]);
  if (k > 1 && common < kInCommon) common = std::max(common, commonWalls(scans[k - 2], scans[k]));
  return std::min(1.0, common / kInCommon);
}

}  // namespace roomgraph
