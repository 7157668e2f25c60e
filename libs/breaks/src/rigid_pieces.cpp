#include "roomgraph/breaks/rigid_pieces.h"

#include <algorithm>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/geometry/NearPlaces.h"

namespace roomgraph {

std::vector<std::vector<std::size_t>> rigidPieces(const WallPatches& patches,
                                                  const FollowedWalls& followed) {
  const std::vector<FollowedPatch>& found = followed.patches;
  const auto holdTogether = [&](const FollowedPatch& f, const FollowedPatch& g) {
    const Point a = patches[f.patch].middle, b = patches[g.patch].middle;
    return distance(a, b) <= kPieceReach &&
           areNear(f.pose, g.pose, midpoint(a, b), kSameScanAnswer);
  };
  UnionFind sets(found.size());
  std::vector<Point> middles;
  for (const FollowedPatch& f : found) middles.push_back(patches[f.patch].middle);
  const NearPlaces near(middles, kPieceReach);
  double all = 0;
  for (std::uint32_t i = 0; i < found.size(); ++i) {
    all += found[i].walls;
    near.forEachNear(middles[i], [&](std::uint32_t j) {
      if (j < i && holdTogether(found[i], found[j])) sets.join(i, j);
    });
  }
  std::vector<std::vector<std::size_t>> pieces(found.size());
  std::vector<double> walls(found.size());
  for (std::uint32_t i = 0; i < found.size(); ++i) {
    pieces[sets.find(i)].push_back(i);
    walls[sets.find(i)] += found[i].walls;
  }
  const auto wallsOf = [&](const std::vector<std::size_t>& piece) {
    return piece.empty() ? 0 : walls[piece.front()];  // a set is known by its first member
  };
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(),
                              [&](const auto& piece) {
                                return piece.empty() || wallsOf(piece) < kLeastPiece * all;
                              }),
               pieces.end());
  std::stable_sort(pieces.begin(), pieces.end(),
                   [&](const auto& l, const auto& r) { return wallsOf(l) > wallsOf(r); });
  return pieces;
}

}  // namespace roomgraph
