#include "roomgraph/align/fit_scale.h"

#include <cmath>

#include "roomgraph/align/Look.h"
#include "roomgraph/align/WallFit.h"

namespace roomgraph {
namespace {

using ScaleStep = WallStep<4>;

ScaleStep stepAt(const WallMap& a, const WallMap& b, const ScaledPose& at, double width) {
  const Motion2D forth(at.pose), back(at.pose.inverse());
  ScaleStep step{forth(at.scale * b.middle()), width};
  const std::size_t strideA = strideOf(a, kCloseLook.verifyPoints);
  const std::size_t strideB = strideOf(b, kCloseLook.verifyPoints);
  for (std::size_t i = 0; i < b.walls.size(); i += strideB) {
    const Point moved = forth(at.scale * b.walls[i].place);
    const WallPoint* wall = nearestWall(a, moved, forth.turned(b.walls[i].normal));
    if (wall) step.add(moved, *wall);
  }
  for (std::size_t i = 0; i < a.walls.size(); i += strideA) {
    const Point place = (1 / at.scale) * back(a.walls[i].place);
    const WallPoint* wall = nearestWall(b, place, back.turned(a.walls[i].normal));
    if (wall)
      step.add(forth(at.scale * wall->place), {a.walls[i].place, forth.turned(wall->normal)});
  }
  return step;
}

}  // namespace

ScaledPose fitScale(const WallMap& a, const WallMap& b, const Transform2D& pose, double reach) {
  const NarrowingBand band{reach, 0.2, 12};
  ScaledPose at{1, pose};
  if (a.walls.empty() || b.walls.empty()) return at;
  for (int i = 0; i < band.steps; ++i) {
    const ScaleStep step = stepAt(a, b, at, band.widthAt(i));
    if (step.weight < 4) break;
    const Eigen::Vector4d by = step.solution(Eigen::Vector4d::Constant(kShiftHold * step.weight));
    at.scale *= std::exp(by[3]);
    at.pose =
        carrying(at.scale * b.middle(), step.pivot + Point{by[0], by[1]}, at.pose.phi + by[2]);
  }
  return at;
}

}  // namespace roomgraph
