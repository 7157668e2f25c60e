#include "roomgraph/relate/sight_walls.h"

#include <cmath>
#include <limits>

#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

/** For each patch of a map where the nearest one that was found lies in another map. */
std::vector<Transform2D> posesOfPatches(const WallMap& map, const FollowedWalls& followed) {
  std::vector<Transform2D> poses;
  for (const WallPatch& patch : map.patches) {
    double nearest = std::numeric_limits<double>::infinity();
    poses.push_back(followed.pose);
    for (const FollowedPatch& found : followed.patches) {
      const double apart = distance(map.patches[found.patch].middle, patch.middle);
      if (found.layer == 0 && apart < nearest) nearest = apart, poses.back() = found.pose;
    }
  }
  return poses;
}

/** Whether a wall goes on straight for the side of a patch, but for a tenth of it. */
bool isStraight(const WallMap& map, const WallPoint& wall) {
  const int steps = int(std::lround(kPatchSide / kWallCell));
  const Point along = kWallCell * toLeft(wall.normal);
  for (const int first : {-steps, -steps / 2, 0}) {
    int gaps = 0;
    for (int step = first; step <= first + steps && 10 * gaps <= steps; ++step) {
      const Point place = wall.place + double(step) * along;
      const WallPoint* next = nearestWall(map, place, wall.normal);
      gaps += !next || distance(next->place, place) >= kSameWall;
    }
    if (10 * gaps <= steps) return true;
  }
  return false;
}

/** What the other map has at a place, where maps bend. */
WallSighting sightingAt(const WallMap& other, Point place, Point normal) {
  const std::size_t cell = cellIndexAt(other.frame, place);
  if (cell >= other.states.size()) return WallSighting::unknown;
  const WallPoint* wall = nearestWall(other, cell, normal);
  if (wall && distance(wall->place, place) < kSameWhereBent) return WallSighting::found;
  if (other.depths[cell] > kSameWhereBent) return WallSighting::free;
  const std::size_t front = cellIndexAt(other.frame, place + kSameWhereBent * normal);
  const bool isSeen = front < other.states.size() && other.depths[front] > kSameWall;
  return isSeen ? WallSighting::faded : WallSighting::unknown;
}

}  // namespace

std::vector<WallSighting> sightWalls(const WallMap& map, const WallMap& other,
                                     const FollowedWalls& followed) {
  std::vector<WallSighting> seen(map.walls.size(), WallSighting::unknown);
  if (followed.patches.empty()) return seen;
  const std::vector<Transform2D> poses = posesOfPatches(map, followed);
  for (std::size_t p = 0; p < poses.size(); ++p) {
    const Motion2D motion(poses[p]);
    for (const std::uint32_t i : map.patches[p].own)
      seen[i] = sightingAt(other, motion(map.walls[i].place), motion.turned(map.walls[i].normal));
  }
  return seen;
}

std::vector<bool> straightWalls(const WallMap& map) {
  return mapped(map.walls, [&](const WallPoint& wall) { return isStraight(map, wall); });
}

}  // namespace roomgraph
