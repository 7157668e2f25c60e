#include "roomgraph/breaks/rigid_pieces.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "roomgraph/base/UnionFind.h"

namespace roomgraph {

std::size_t rigidPieces(const WallPatches& patches, const FollowedWalls& followed,
                        const RigidPiecesOptions& options) {
  const std::vector<FollowedPatch>& found = followed.patches;
  const auto holdTogether = [&](const FollowedPatch& f, const FollowedPatch& g) {
    const Point a = patches[f.patch].middle, b = patches[g.patch].middle;
    if (distance(a, b) > options.reach) return false;
    if (std::abs(wrappedAngle(f.pose.phi - g.pose.phi)) > options.maxTurn) return false;
    const Point between = midpoint(a, b);
    return distance(f.pose(between), g.pose(between)) <= options.maxShift;
  };
  UnionFind pieces(found.size());
  double all = 0;
  for (std::uint32_t i = 0; i < found.size(); ++i) {
    all += found[i].walls;
    for (std::uint32_t j = 0; j < i; ++j)
      if (holdTogether(found[i], found[j])) pieces.join(i, j);
  }
  std::vector<double> walls(found.size());
  for (std::uint32_t i = 0; i < found.size(); ++i) walls[pieces.find(i)] += found[i].walls;
  return std::size_t(std::count_if(walls.begin(), walls.end(), [&](double of) {
    return of > 0 && of >= options.minShare * all;
  }));
}

}  // namespace roomgraph
