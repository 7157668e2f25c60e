#include "roomgraph/align/WallFit.h"

#include <Eigen/Dense>

#include "roomgraph/align/nearest_wall.h"

namespace roomgraph {

void WallFit::add(const WallPoint& point, const WallMap& in) {
  const Point at = forth_(point.place);
  const WallPoint* wall = nearestWall(in, cellIndexAt(in.frame, at), forth_.turned(point.normal));
  if (wall) add(at, *wall);
}

void WallFit::add(Point place, const WallPoint& wall) {
  const Point off = place - wall.place;
  const double s = 1 + squaredNorm(off) / (width_ * width_), w = 1 / (s * s);
  const Row j{wall.normal.x, wall.normal.y, cross(place - pivot_, wall.normal)};
  const double pull = w * dot(wall.normal, off);
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c <= r; ++c) h_[r][c] += w * j[r] * j[c];
    g_[r] -= pull * j[r];
  }
  weight_ += w;
}

Transform2D WallFit::improved(double turnHold) const {
  Eigen::Matrix3d h = Eigen::Matrix3d::Zero();
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c <= r; ++c) h(r, c) = h_[std::size_t(r)][std::size_t(c)];
  h.diagonal() += weight_ * Eigen::Vector3d(kShiftHold, kShiftHold, turnHold);
  const Eigen::Vector3d by = h.ldlt().solve(Eigen::Vector3d(g_[0], g_[1], g_[2]));
  return carrying(pivot_, pivot_ + Point{by[0], by[1]}, by[2]) * pose_;
}

}  // namespace roomgraph
