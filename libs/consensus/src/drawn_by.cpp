#include "roomgraph/consensus/drawn_by.h"

#include <algorithm>
#include <utility>

#include "roomgraph/align/nearest_wall.h"

namespace roomgraph {
namespace {

using Drawn = std::vector<std::pair<std::uint32_t, NodeId>>;  // wall point, node

Drawn drawnInScans(const std::vector<ScanWalls>& scans, IdRange<NodeId> nodes, const WallMap& map) {
  Drawn drawn;
  for (const NodeId node : nodes)
    for (const WallPoint& point : scans[nodes.placeOf(node)].walls) {
      const WallPoint* wall = nearestWall(map, cellIndexAt(map.frame, point.place), point.normal);
      if (wall && distance(wall->place, point.place) < kSameWall)
        drawn.emplace_back(std::uint32_t(wall - map.walls.data()), node);
    }
  return drawn;
}

Drawn drawnInPatches(const WallPatches& patches, IdRange<NodeId> nodes) {
  Drawn drawn;
  for (const NodeId node : nodes)
    for (const std::uint32_t wall : patches[nodes.placeOf(node)].own)
      drawn.emplace_back(wall, node);
  return drawn;
}

}  // namespace

DrawnBy drawnBy(const Run& run, IdRange<NodeId> nodes, const WallMap& map) {
  Drawn drawn =
      run.scans.empty() ? drawnInPatches(map.patches, nodes) : drawnInScans(run.scans, nodes, map);
  std::sort(drawn.begin(), drawn.end());
  drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
  DrawnBy result;
  for (std::size_t next = 0, wall = 0; wall <= map.walls.size(); ++wall) {
    while (next < drawn.size() && drawn[next].first < wall) ++next;
    result.firsts.push_back(std::uint32_t(next));
  }
  for (const auto& [wall, node] : drawn) result.nodes.push_back(node);
  return result;
}

}  // namespace roomgraph
