#include "look_again.h"

#include <algorithm>

#include "confirm_runs.h"
#include "fitted_consensus.h"
#include "roomgraph/align/align_maps.h"
#include "roomgraph/align/scan_map.h"
#include "roomgraph/align/step_hold.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

/** Whether the scans of a run part within a few steps of the one to scan k. */
bool partNear(const std::vector<ScanWalls>& scans, std::size_t k) {
  constexpr auto near = std::size_t(fitted::kLeastLostOnEnd);
  const std::size_t last = std::min(scans.size(), k + near + 1);
  for (std::size_t i = std::max(k, near + 1) - near; i < last; ++i)
    if (stepHold(scans, i) < kMajority) return true;
  return false;
}

}  // namespace

std::vector<Transform2D> lookAgain(const std::vector<ScanWalls>& scans,
                                   const std::vector<std::optional<Transform2D>>& track,
                                   const WallMap& in) {
  const auto isFound = mapped(track, [](const auto& pose) { return pose.has_value(); });
  std::vector<Transform2D> poses;
  for (const ScanStretch& gap : gapsOf(isFound)) {
    if (gap.size() == scans.size() || !isLong(gap, scans)) continue;
    if (!partNear(scans, gap.first) && !partNear(scans, gap.end)) continue;
    const WallMap drawn = stretchMap(scans, gap.first, gap.end);
    const std::vector<Transform2D> found = alignMaps(in, drawn, kQuickSearch).poses;
    poses.insert(poses.end(), found.begin(),
                 found.begin() + std::ptrdiff_t(std::min(fitted::kCandidates, found.size())));
  }
  return poses;
}

}  // namespace roomgraph
