#include "lost_scans.h"

#include <algorithm>

#include "fitted_consensus.h"
#include "roomgraph/align/nearest_wall.h"

namespace roomgraph {
namespace {

constexpr std::size_t kLeastWalls = 10;  // of a scan that can be told from others
constexpr double kLeastKnown = 0.5;      // of its walls, where a place counts as known

/** Whether a map knows the place of most walls of a scan. */
bool knows(const WallMap& map, const ScanWalls& scan, const Transform2D& pose) {
  const auto known = std::count_if(scan.walls.begin(), scan.walls.end(),
                                   [&, forth = Motion2D(pose)](const WallPoint& wall) {
                                     return hasSeen(map, cellIndexAt(map.frame, forth(wall.place)));
                                   });
  return double(known) > kLeastKnown * double(scan.walls.size());
}

/** Leaves only stretches that are long enough. */
void dropStray(std::vector<bool>& isLost) {
  for (auto from = isLost.begin(); from != isLost.end();) {
    from = std::find(from, isLost.end(), true);
    const auto to = std::find(from, isLost.end(), false);
    if (to - from < fitted::kLeastLostOnEnd) std::fill(from, to, false);
    from = to;
  }
}

}  // namespace

std::vector<std::vector<bool>> lostScans(const Site& site, const MapPairs& pairs,
                                         const std::vector<std::size_t>& counted,
                                         const Consensus& consensus) {
  std::vector<std::vector<bool>> lost;
  for (std::size_t i = 0; i < site.runs.size(); ++i) {
    const std::vector<ScanWalls>& scans = site.runs[i]->scans;
    std::vector<bool>& isLost = lost.emplace_back(scans.size());
    if (counted[i] != i || (site.reference && i == counted[*site.reference])) continue;
    for (std::size_t k = 0; k < scans.size(); ++k) {
      if (consensus.errors[i].isSeen[k] || scans[k].walls.size() < kLeastWalls) continue;
      const Transform2D there = consensus.poses[i][k] * scans[k].pose.inverse();
      const auto& others = pairs.othersOf(i);
      const auto knowing = std::count_if(others.begin(), others.end(), [&](std::size_t j) {
        return counted[j] == j &&
               knows(site.runs[j]->map, scans[k], consensus.errors[j].pose.inverse() * there);
      });
      isLost[k] = knowing >= fitted::kLeastKnowing;
    }
    dropStray(isLost);
  }
  return lost;
}

}  // namespace roomgraph
