#pragma once
#include <Eigen/Dense>

#include "roomgraph/align/MapForAlignment.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** One step of laying wall points onto the walls of a map, in (shift x, shift y, turn) about the
 *  place where `about` comes to lie. Distances count across the wall; far ones count little. */
class WallFit {
 public:
  WallFit(const Transform2D& pose, Point about, double width)
      : pose_(pose), forth_(pose), pivot_(forth_(about)), width_(width) {}

  void add(const WallPoint& point, const MapForAlignment& in) {
    const Point at = forth_(point.place);
    const WallPoint* wall = nearestWall(in, cellIndexAt(in.frame, at), forth_.turned(point.normal));
    if (!wall) return;
    const Point off = at - wall->place;
    const double s = 1 + squaredNorm(off) / (width_ * width_), w = 1 / (s * s);
    const Eigen::Vector3d j(wall->normal.x, wall->normal.y, cross(at - pivot_, wall->normal));
    h_ += w * j * j.transpose();
    g_ -= w * dot(wall->normal, off) * j;
    weight_ += w;
  }

  bool isEnough() const { return weight_ >= 3; }

  /** The pose after the step. What no wall holds stays as it is. */
  Transform2D improved() const {
    Eigen::Matrix3d h = h_;
    h.diagonal() += weight_ * Eigen::Vector3d(0.02, 0.02, 0.08);
    const Eigen::Vector3d by = h.ldlt().solve(g_);
    return carrying(pivot_, pivot_ + Point{by[0], by[1]}, by[2]) * pose_;
  }

 private:
  Transform2D pose_;
  Motion2D forth_;
  Point pivot_;
  double width_, weight_ = 0;
  Eigen::Matrix3d h_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g_ = Eigen::Vector3d::Zero();
};

}  // namespace roomgraph
