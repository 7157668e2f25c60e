#pragma once
#include <vector>

#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

// Of runs with scans `benchmarks/score_accuracy --data DIR` shows what a change does, of pictures
// `benchmarks/alignment_accuracy --data DIR`.

/** Wall points that speak against each pose beforehand, so that few found ones prove little. */
constexpr double kDoubt = 5;
/** Fewer tell no pose of their own. */
constexpr std::size_t kFewestPoints = 15;
/** Share of them that is found from which on a pose that others lead to is worth a look. */
constexpr double kFairQuality = 0.3;
/** The same from which on no other pose is looked for: what is left is too little for one. */
constexpr double kSureQuality = 1 - kFairQuality;
/** Of every so manyth point are poses told by that are only compared. */
constexpr std::size_t kQuickStride = 3;

/** Where a wall point lies in a map. */
struct WallLookUp {
  Point place, normal;              ///< [frame of the map]
  bool isKnown = false;             ///< the map has looked there
  const WallPoint* wall = nullptr;  ///< the nearest that faces alike; null where none is in reach

  /** 1 on that wall, a half where it is `near` away, and 0 without one. */
  double found(double near) const {
    return wall ? 1 / (1 + squaredNorm(wall->place - place) / (near * near)) : 0;
  }
};

/** Looks up a point where `forth` brings it. O(1). */
inline WallLookUp lookUp(const WallPoint& point, const WallMap& map, const Motion2D& forth) {
  WallLookUp there{forth(point.place), {}};
  const std::size_t cell = cellIndexAt(map.frame, there.place);
  if (!hasSeen(map, cell)) return there;
  there.isKnown = true;
  there.normal = forth.turned(point.normal);
  there.wall = nearestWall(map, cell, there.normal);
  return there;
}

/** Of some wall points, how many lie where a map has looked, and how many of these on walls there:
 *  each counts by its distance to the nearest, half at `near`. */
struct WallShare {
  double all = 0, known = 0, found = 0;

  /** The share of the known points that was found; `doubt` more count as known, and not found. */
  double ofKnown(double doubt = 0) const { return known > 0 ? found / (known + doubt) : 0; }
};

/** Looks up every `stride`th of the points pointAt(0 to count - 1) where `pose` brings it. Comes
 *  back with nothing as soon as their ofKnown(doubt) is sure to be less than `least`. */
template <class PointAt>
WallShare wallShare(std::size_t count, const PointAt& pointAt, const WallMap& map,
                    const Transform2D& pose, double near = kWallNoise, std::size_t stride = 1,
                    double least = 0, double doubt = 0) {
  const Motion2D forth(pose);
  WallShare share;
  const std::size_t asked = (count + stride - 1) / stride;
  auto left = double(asked);
  for (std::size_t i = 0; i < count; i += stride, ++share.all, --left) {
    if (share.found + left < least * (share.known + left + doubt)) return {};
    const WallLookUp there = lookUp(pointAt(i), map, forth);
    share.known += there.isKnown, share.found += there.found(near);
  }
  return share;
}

/** The same of those walls of a map of whose places in it isChosen(place) is true. */
template <class IsChosen>
WallShare shareOfChosen(const WallMap& map, const IsChosen& isChosen, const WallMap& other,
                        const Transform2D& pose) {
  std::vector<const WallPoint*> chosen;
  for (std::size_t k = 0; k < map.walls.size(); ++k)
    if (isChosen(k)) chosen.push_back(&map.walls[k]);
  const auto pointAt = [&](std::size_t i) -> const WallPoint& { return *chosen[i]; };
  return wallShare(chosen.size(), pointAt, other, pose);
}

}  // namespace roomgraph
