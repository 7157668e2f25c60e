#include "roomgraph/align/fit_scale.h"

#include <Eigen/Dense>
#include <cmath>

#include "roomgraph/align/Look.h"
#include "roomgraph/align/WallFit.h"

namespace roomgraph {
namespace {

/** The normal equations of one step, in (shift x, shift y, turn, growth) about `pivot`. */
struct ScaleStep {
  Point pivot;
  double width;
  Eigen::Matrix4d h = Eigen::Matrix4d::Zero();
  Eigen::Vector4d g = Eigen::Vector4d::Zero();
  double weight = 0;

  /** `moved` belongs onto `target`, across `normal`. */
  void add(Point moved, Point target, Point normal) {
    const double s = 1 + squaredNorm(moved - target) / (width * width), w = 1 / (s * s);
    const Point arm = moved - pivot;
    const Eigen::Vector4d j(normal.x, normal.y, cross(arm, normal), dot(arm, normal));
    h += w * j * j.transpose();
    g -= w * dot(normal, moved - target) * j;
    weight += w;
  }

  Eigen::Vector4d solution() const {
    Eigen::Matrix4d held = h;
    held.diagonal() += Eigen::Vector4d::Constant(kShiftHold * weight);
    return held.ldlt().solve(g);
  }
};

ScaleStep stepAt(const WallMap& a, const WallMap& b, const ScaledPose& at, double width) {
  const Motion2D forth(at.pose), back(at.pose.inverse());
  ScaleStep step{forth(at.scale * b.middle()), width};
  const std::size_t strideA = strideOf(a, kCloseLook.verifyPoints);
  const std::size_t strideB = strideOf(b, kCloseLook.verifyPoints);
  for (std::size_t i = 0; i < b.walls.size(); i += strideB) {
    const Point moved = forth(at.scale * b.walls[i].place);
    const WallPoint* wall = nearestWall(a, moved, forth.turned(b.walls[i].normal));
    if (wall) step.add(moved, wall->place, wall->normal);
  }
  for (std::size_t i = 0; i < a.walls.size(); i += strideA) {
    const Point place = (1 / at.scale) * back(a.walls[i].place);
    const WallPoint* wall = nearestWall(b, place, back.turned(a.walls[i].normal));
    if (wall) step.add(forth(at.scale * wall->place), a.walls[i].place, forth.turned(wall->normal));
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
    const Eigen::Vector4d by = step.solution();
    at.scale *= std::exp(by[3]);
    at.pose =
        carrying(at.scale * b.middle(), step.pivot + Point{by[0], by[1]}, at.pose.phi + by[2]);
  }
  return at;
}

}  // namespace roomgraph
