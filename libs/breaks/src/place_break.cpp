#include "roomgraph/breaks/place_break.h"

#include <algorithm>

namespace roomgraph {
namespace {

constexpr std::size_t kFar = 5;
constexpr double kNear = 0.2, kAlike = 0.8;  // of walls that are the same [m, cosine]
constexpr double kPlain = 0.6;               // share of the walls in common beside those at `found`

/** The share of a scan's walls that the scan before it has, too. */
double inCommon(const ScanWalls& before, const ScanWalls& scan) {
  const auto isThere = [&](const WallPoint& wall) {
    return std::any_of(before.walls.begin(), before.walls.end(), [&](const WallPoint& other) {
      return distance(other.place, wall.place) < kNear && dot(other.normal, wall.normal) > kAlike;
    });
  };
  const auto count = std::count_if(scan.walls.begin(), scan.walls.end(), isThere);
  return scan.walls.empty() ? 1 : double(count) / double(scan.walls.size());
}

}  // namespace

std::size_t placeBreak(const std::vector<ScanWalls>& scans, const std::vector<bool>& isSeen,
                       std::size_t found) {
  std::size_t first = found, last = found;
  while (first > 1 && found - first < kFar && !isSeen[first - 1]) --first;
  while (last + 1 < scans.size() && last - found < kFar && !isSeen[last]) ++last;
  std::size_t place = found;
  double least = kPlain * inCommon(scans[found - 1], scans[found]);
  for (std::size_t k = first; k <= last; ++k)
    if (const double share = inCommon(scans[k - 1], scans[k]); share < least)
      least = share, place = k;
  return place;
}

}  // namespace roomgraph
