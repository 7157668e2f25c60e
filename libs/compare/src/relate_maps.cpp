#include "roomgraph/compare/relate_maps.h"

#include <algorithm>

namespace roomgraph {
namespace {

bool areTheSame(const MapForAlignment& l, const MapForAlignment& r) {
  return l.states == r.states && l.walls.size() == r.walls.size() &&
         std::equal(l.walls.begin(), l.walls.end(), r.walls.begin(),
                    [](const WallPoint& p, const WallPoint& q) { return p.place == q.place; });
}

/** All patches at `pose`: where two maps are the same, following could only blur that. */
FollowedWalls carried(const MapForAlignment& map, const Transform2D& pose) {
  FollowedWalls all;
  for (std::uint32_t i = 0; i < map.patches.size(); ++i)
    all.patches.push_back({i, pose, double(map.patches[i].own.size()), 0});
  all.pose = pose;
  all.share = 1;
  return all;
}

}  // namespace

void follow(MapPair& pair, const MapForAlignment& a, const MapForAlignment& b,
            const std::vector<Transform2D>& poses) {
  if (pair.areIdentical) {
    pair.bInA = carried(b, poses.front()), pair.aInB = carried(a, poses.front().inverse());
    return;
  }
  std::vector<Transform2D> back;
  for (const Transform2D& pose : poses) back.push_back(pose.inverse());
  pair.bInA = followWalls(b, a, poses, {});
  pair.aInB = followWalls(a, b, back, {});
}

MapPair relateMaps(const MapForAlignment& a, const MapForAlignment& b) {
  MapPair pair;
  pair.alignment = alignMaps(a, b, {});
  pair.areIdentical = areTheSame(a, b);
  if (pair.alignment.isSameSite) follow(pair, a, b, pair.alignment.poses);
  return pair;
}

MapPair relateAlignedMaps(const MapForAlignment& a, const MapForAlignment& b) {
  MapPair pair;
  Alignment& alignment = pair.alignment;
  alignment.best = AlignmentCandidate{};
  alignment.best->evidence = verifyAlignment(a, b, {}, {});
  alignment.overlap = alignment.best->evidence.overlap;
  alignment.confidence = alignment.siteConfidence = 1;
  alignment.isSameSite = true;
  alignment.poses = {{}};
  pair.areIdentical = areTheSame(a, b);
  follow(pair, a, b, alignment.poses);
  return pair;
}

}  // namespace roomgraph
