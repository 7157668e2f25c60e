#include "beams_through_walls.h"

#include "Passes.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/majority.h"

namespace roomgraph {
namespace {

bool isThrough(const WallMap& map, std::size_t cell, Point place, Point normal) {
  if (map.states[cell] != State::free) return false;
  const WallPoint* wall = nearestWall(map, cell, normal);
  return !wall || distance(wall->place, place) > 2 * kSameWall;
}

/** What beams of a pass tell of the walls of one scan, which lies at `pose`. */
BeamsThroughWalls beamsOf(const LocalScan& scan, const WallMap& map, const Transform2D& pose) {
  BeamsThroughWalls beams;
  if (map.walls.empty()) return beams;
  const Motion2D forth(pose);
  for (const WallPoint& wall : scan.walls) {
    const Point place = forth(wall.place);
    const std::size_t cell = cellIndexAt(map.frame, place);
    if (!hasSeen(map, cell)) continue;
    ++beams.walls;
    beams.through += isThrough(map, cell, place, forth.turned(wall.normal));
  }
  return beams;
}

bool isOverlaid(const BeamsThroughWalls& beams) {
  return beams.walls >= LocalScan::kTelling &&
         double(beams.through) > kMajority * double(beams.walls);
}

}  // namespace

BeamsThroughWalls beamsThroughWalls(const std::vector<LocalScan>& scans,
                                    const std::vector<Transform2D>& poses) {
  const Passes passes(scans, poses);
  BeamsThroughWalls beams;
  for (std::size_t k = 0; k < scans.size(); ++k)
    for (const std::size_t s : passes.besideScan(k)) {
      const Pass& pass = passes.all()[s];
      const BeamsThroughWalls one = beamsOf(scans[k], pass.map, poses[k]);
      beams.walls += one.walls, beams.through += one.through;
      if (isOverlaid(one))
        beams.overlaid.push_back(scanPair(k, passes.nearestScan(pass, poses[k].shift())));
    }
  return beams;
}

}  // namespace roomgraph
