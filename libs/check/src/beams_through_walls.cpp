#include "beams_through_walls.h"

#include "Passes.h"
#include "roomgraph/align/nearest_wall.h"

namespace roomgraph {
namespace {

bool isThrough(const WallMap& map, std::size_t cell, Point at, Point normal) {
  if (map.states[cell] != State::free) return false;
  const WallPoint* wall = nearestWall(map, cell, normal);
  return !wall || distance(wall->place, at) > 2 * kSameWall;
}

}  // namespace

BeamsThroughWalls beamsThroughWalls(const std::vector<LocalScan>& scans,
                                    const std::vector<Transform2D>& poses) {
  const Passes passes(scans, poses);
  BeamsThroughWalls beams;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const Motion2D forth(poses[k]);
    for (const std::size_t s : passes.besideScan(k)) {
      const WallMap& map = passes.all()[s].map;
      for (const WallPoint& wall : scans[k].walls) {
        const Point at = forth(wall.place);
        const std::size_t cell = cellIndexAt(map.frame, at);
        if (map.walls.empty() || !hasSeen(map, cell)) continue;
        ++beams.walls;
        beams.through += isThrough(map, cell, at, forth.turned(wall.normal));
      }
    }
  }
  return beams;
}

}  // namespace roomgraph
