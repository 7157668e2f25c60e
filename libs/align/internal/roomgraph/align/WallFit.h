#pragma once
#include <Eigen/Dense>

#include "roomgraph/align/NarrowingBand.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** How much it takes to shift what no wall holds, as a share of all that counts. */
constexpr double kShiftHold = 0.02;

/** The normal equations of one step that lays places onto walls: in shift x, shift y and turn about
 *  `pivot`, and in growth where that is the fourth unknown. Distances count across the wall; far
 *  ones little. */
template <int Unknowns>
struct WallStep {
  using Vector = Eigen::Matrix<double, Unknowns, 1>;
  using Matrix = Eigen::Matrix<double, Unknowns, Unknowns>;

  Point pivot;
  double width = 0;  ///< up to which distances count [m]
  Matrix h = Matrix::Zero();
  Vector g = Vector::Zero();
  double weight = 0;  ///< of all that was added

  void add(Point place, const WallPoint& wall) {
    const Point off = place - wall.place, arm = place - pivot;
    const double s = 1 + squaredNorm(off) / (width * width), w = 1 / (s * s);
    Vector j;
    j[0] = wall.normal.x, j[1] = wall.normal.y, j[2] = cross(arm, wall.normal);
    if constexpr (Unknowns == 4) j[3] = dot(arm, wall.normal);
    h += w * j * j.transpose();
    g -= w * dot(wall.normal, off) * j;
    weight += w;
  }

  /** What no wall holds stays as it is: `hold` is how much it takes to move it. */
  Vector solution(const Vector& hold) const {
    Matrix held = h;
    held.diagonal() += hold;
    return held.ldlt().solve(g);
  }
};

/** One step of laying wall points onto the walls of a map, from a pose that brings `about` to the
 *  pivot. */
class WallFit {
 public:
  WallFit(const Transform2D& pose, Point about, double width)
      : pose_(pose), forth_(pose), step_{forth_(about), width} {}

  const Transform2D& pose() const { return pose_; }
  const Motion2D& forth() const { return forth_; }

  /** A point that is to be laid on the nearest wall of `in`. */
  void add(const WallPoint& point, const WallMap& in) {
    const Point at = forth_(point.place);
    const WallPoint* wall = nearestWall(in, at, forth_.turned(point.normal));
    if (wall) add(at, *wall);
  }
  /** One that the pose has brought to `place`, and that belongs onto `wall`. */
  void add(Point place, const WallPoint& wall) { step_.add(place, wall); }

  bool isEnough() const { return step_.weight >= 3; }

  /** The pose after the step; `turnHold`: how much it takes to turn, as a share of all that counts.
   */
  Transform2D improved(double turnHold) const {
    const Eigen::Vector3d by =
        step_.solution(step_.weight * Eigen::Vector3d(kShiftHold, kShiftHold, turnHold));
    return carrying(step_.pivot, step_.pivot + Point{by[0], by[1]}, by[2]) * pose_;
  }

 private:
  Transform2D pose_;
  Motion2D forth_;
  WallStep<3> step_;
};

/** The pose that several steps come to, each with the walls that `addWalls(fit, step)` adds. It
 *  stays where too few walls are in reach. The walls of a patch lie close together, so that they
 *  hold its turn less well than its place. */
template <class AddWalls>
Transform2D fittedPose(Transform2D pose, Point about, const NarrowingBand& band,
                       const AddWalls& addWalls, double turnHold = 0.08) {
  for (int step = 0; step < band.steps; ++step) {
    WallFit fit(pose, about, band.widthAt(step));
    addWalls(fit, step);
    if (!fit.isEnough()) break;
    pose = fit.improved(turnHold);
  }
  return pose;
}

}  // namespace roomgraph
