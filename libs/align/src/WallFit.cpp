#include "roomgraph/align/WallFit.h"

#include <Eigen/Dense>

namespace roomgraph {

Transform2D WallFit::improved(double turnHold) const {
  Eigen::Matrix3d h = Eigen::Matrix3d::Zero();
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c <= r; ++c) h(r, c) = h_[std::size_t(r)][std::size_t(c)];
  h.diagonal() += weight_ * Eigen::Vector3d(kShiftHold, kShiftHold, turnHold);
  const Eigen::Vector3d by = h.ldlt().solve(Eigen::Vector3d(g_[0], g_[1], g_[2]));
  return carrying(pivot_, pivot_ + Point{by[0], by[1]}, by[2]) * pose_;
}

}  // namespace roomgraph
