#include "lost_scans.h"

#include <algorithm>

#include "fitted_consensus.h"
#include "roomgraph/align/LocalScan.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/majority.h"

namespace roomgraph {
namespace {

/** Whether a map knows the place of most walls of a scan. */
bool knows(const WallMap& map, const ScanWalls& scan, const Transform2D& pose) {
  const auto known = std::count_if(scan.walls.begin(), scan.walls.end(),
                                   [&, forth = Motion2D(pose)](const WallPoint& wall) {
                                     return hasSeen(map, cellIndexAt(map.frame, forth(wall.place)));
                                   });
  return double(known) > kMajority * double(scan.walls.size());
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

ById<RunId, std::vector<bool>> lostScans(const Site& site, const MapPairs& pairs,
                                         const Consensus& consensus) {
  ById<RunId, std::vector<bool>> lost;
  for (const RunId run : consensus.graph.runs.ids()) {
    const std::size_t i = consensus.siteRuns[run];
    const std::vector<ScanWalls>& scans = site.runs[i]->scans;
    std::vector<bool>& isLost = lost[lost.add(std::vector<bool>(scans.size()))];
    if (run == consensus.graph.reference) continue;
    for (std::size_t k = 0; k < scans.size(); ++k) {
      if (consensus.errors[run].isSeen[k] || scans[k].walls.size() < LocalScan::kTelling) continue;
      const NodeId node = consensus.graph.runs[run].nodes[k];
      const Transform2D there = consensus.poses[node] * scans[k].pose.inverse();
      const auto& others = pairs.othersOf(i);
      const auto knowing = std::count_if(others.begin(), others.end(), [&](std::size_t j) {
        return consensus.isCounted(j) &&
               knows(site.runs[j]->map, scans[k],
                     consensus.errors[consensus.graphRuns[j]].pose.inverse() * there);
      });
      isLost[k] = knowing >= fitted::kLeastKnowing;
    }
    dropStray(isLost);
  }
  return lost;
}

}  // namespace roomgraph
