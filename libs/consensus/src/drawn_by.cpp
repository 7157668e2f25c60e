#include "roomgraph/consensus/drawn_by.h"

#include <algorithm>
#include <utility>

#include "roomgraph/align/nearest_wall.h"

namespace roomgraph {
namespace {

using Drawn = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // wall point, submap

Drawn drawnInScans(const std::vector<ScanWalls>& scans, const WallMap& map) {
  Drawn drawn;
  for (std::uint32_t k = 0; k < scans.size(); ++k)
    for (const WallPoint& point : scans[k].walls) {
      const WallPoint* wall = nearestWall(map, cellIndexAt(map.frame, point.place), point.normal);
      if (wall && distance(wall->place, point.place) < kSameWall)
        drawn.emplace_back(std::uint32_t(wall - map.walls.data()), k);
    }
  return drawn;
}

Drawn drawnInPatches(const WallPatches& patches) {
  Drawn drawn;
  for (std::uint32_t k = 0; k < patches.size(); ++k)
    for (const std::uint32_t wall : patches[k].own) drawn.emplace_back(wall, k);
  return drawn;
}

}  // namespace

DrawnBy drawnBy(const Run& run, const WallMap& map) {
  Drawn drawn = run.scans.empty() ? drawnInPatches(map.patches) : drawnInScans(run.scans, map);
  std::sort(drawn.begin(), drawn.end());
  drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
  DrawnBy result;
  for (std::size_t next = 0, wall = 0; wall <= map.walls.size(); ++wall) {
    while (next < drawn.size() && drawn[next].first < wall) ++next;
    result.firsts.push_back(std::uint32_t(next));
  }
  for (const auto& [wall, submap] : drawn) result.submaps.push_back(submap);
  return result;
}

}  // namespace roomgraph
