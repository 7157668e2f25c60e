#pragma once
#include <array>

#include "roomgraph/align/NarrowingBand.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** How much it takes to shift what no wall holds, as a share of all that counts. */
constexpr double kShiftHold = 0.02;

/** One step of laying wall points onto the walls of a map, in (shift x, shift y, turn) about the
 *  place where `about` comes to lie. Distances count across the wall; far ones count little. */
class WallFit {
 public:
  WallFit(const Transform2D& pose, Point about, double width)
      : pose_(pose), forth_(pose), pivot_(forth_(about)), width_(width) {}

  const Transform2D& pose() const { return pose_; }
  const Motion2D& forth() const { return forth_; }

  /** A point that is to be laid on the nearest wall of `in`. */
  void add(const WallPoint& point, const WallMap& in) {
    const Point at = forth_(point.place);
    const WallPoint* wall = nearestWall(in, at, forth_.turned(point.normal));
    if (wall) add(at, *wall);
  }
  /** One that the pose has brought to `place`, and that belongs onto `wall`. */
  void add(Point place, const WallPoint& wall) {
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

  bool isEnough() const { return weight_ >= 3; }

  /** The pose after the step. What no wall holds stays as it is; `turnHold`: how much it takes to
   *  turn, as a share of all that counts. */
  Transform2D improved(double turnHold) const;

 private:
  using Row = std::array<double, 3>;

  Transform2D pose_;
  Motion2D forth_;
  Point pivot_;
  double width_, weight_ = 0;
  std::array<Row, 3> h_{};  // the normal equations h x = g: of h what is on and below its diagonal
  Row g_{};
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
