#include "walk.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/geometry/Polyline.h"

namespace roomgraph {

std::vector<WalkPose> walk(const std::vector<Point>& corners, int count) {
  const double total = length(corners);
  std::vector<WalkPose> poses;
  std::size_t leg = 1;
  double before = 0;  // length of the legs that are done
  for (int i = 0; i < count; ++i) {
    const double at = total * i / (count - 1);
    while (leg + 1 < corners.size() && before + distance(corners[leg - 1], corners[leg]) < at) {
      before += distance(corners[leg - 1], corners[leg]);
      ++leg;
    }
    const Point from = corners[leg - 1], way = corners[leg] - from;
    const double share = std::min(1.0, (at - before) / distance(from, corners[leg]));
    poses.push_back({from + share * way, std::atan2(way.y, way.x)});
  }
  return poses;
}

}  // namespace roomgraph
