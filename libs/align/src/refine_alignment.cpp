#include "roomgraph/align/refine_alignment.h"

#include <Eigen/Dense>

#include "roomgraph/align/nearest_wall.h"

namespace roomgraph {
namespace {

/** The normal equations of one step, in (shift x, shift y, turn) about `pivot`. */
struct Step {
  Point pivot;
  Eigen::Matrix3d h = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  double weight = 0;

  /** `moved` belongs onto `target`, across `normal`. */
  void add(Point moved, Point target, Point normal, double width) {
    const double r = dot(normal, moved - target);
    const double s = squaredNorm(moved - target) / (width * width);
    const double w = 1 / ((1 + s) * (1 + s));
    const Eigen::Vector3d j(normal.x, normal.y, cross(moved - pivot, normal));
    h += w * j * j.transpose();
    g -= w * r * j;
    weight += w;
  }
};

std::size_t strideOf(const WallMap& map, int maxPoints) {
  return (map.walls.size() + std::size_t(maxPoints) - 1) / std::size_t(maxPoints);
}

Transform2D moved(const Transform2D& pose, Point pivot, const Eigen::Vector3d& by) {
  const Transform2D about = carrying(pivot, pivot + Point{by[0], by[1]}, by[2]);
  return about * pose;
}

Step stepAt(const WallMap& a, const WallMap& b, const Transform2D& pose, double width,
            const RefineAlignmentOptions& options) {
  Step step;
  step.pivot = pose(b.middle());
  const Motion2D forth(pose), back(pose.inverse());
  const std::size_t strideB = strideOf(b, options.maxPoints);
  for (std::size_t i = 0; i < b.walls.size(); i += strideB) {
    const Point at = forth(b.walls[i].place);
    const WallPoint* wall =
        nearestWall(a, cellIndexAt(a.frame, at), forth.turned(b.walls[i].normal));
    if (wall) step.add(at, wall->place, wall->normal, width);
  }
  const std::size_t strideA = strideOf(a, options.maxPoints);
  for (std::size_t i = 0; i < a.walls.size(); i += strideA) {
    const Point at = back(a.walls[i].place);
    const WallPoint* wall =
        nearestWall(b, cellIndexAt(b.frame, at), back.turned(a.walls[i].normal));
    if (wall) step.add(forth(wall->place), a.walls[i].place, forth.turned(wall->normal), width);
  }
  return step;
}

}  // namespace

Transform2D refineAlignment(const WallMap& a, const WallMap& b, const Transform2D& pose,
                            const RefineAlignmentOptions& options) {
  Transform2D at = pose;
  if (a.walls.empty() || b.walls.empty()) return at;
  for (int i = 0; i < options.band.steps; ++i) {
    const Step step = stepAt(a, b, at, options.band.widthAt(i), options);
    if (step.weight < 3) break;
    Eigen::Matrix3d h = step.h;
    h.diagonal() += Eigen::Vector3d(0.02, 0.02, 0.02) * step.weight;  // holds what nothing holds
    at = moved(at, step.pivot, h.ldlt().solve(step.g));
  }
  return at;
}

}  // namespace roomgraph
