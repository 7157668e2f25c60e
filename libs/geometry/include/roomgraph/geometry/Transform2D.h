#pragma once
#include <cmath>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** The same angle in (-pi, pi] [rad]. */
[[nodiscard]] inline double wrappedAngle(double angle) {
  // Most angles are within a turn of it: the same to the last bit, in a fraction of the time.
  if (angle > -M_PI && angle <= M_PI) return angle;
  if (angle > M_PI && angle < 3 * M_PI) return angle - 2 * M_PI;
  if (angle < -M_PI && angle > -3 * M_PI) return angle + 2 * M_PI;
  const double wrapped = std::remainder(angle, 2 * M_PI);
  return wrapped <= -M_PI ? wrapped + 2 * M_PI : wrapped;
}

/** `v` turned by `angle` [rad], counter-clockwise. */
[[nodiscard]] inline Point turned(Point v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

/** A turn by `phi` followed by a shift: what carries places of one frame into another, "a <- b".
 *  Also the pose of b's origin in a. The default changes nothing. */
struct Transform2D {
  double x = 0, y = 0;  ///< [m]
  double phi = 0;       ///< [rad]

  [[nodiscard]] Point shift() const { return {x, y}; }  ///< [m]
  /** The place in a of a place in b. */
  [[nodiscard]] Point operator()(Point p) const { return turned(p, phi) + shift(); }
  /** b <- a. */
  [[nodiscard]] Transform2D inverse() const {
    const Point back = turned({-x, -y}, -phi);
    return {back.x, back.y, wrappedAngle(-phi)};
  }
  /** (a <- b) * (b <- c) = a <- c. */
  friend Transform2D operator*(const Transform2D& ab, const Transform2D& bc) {
    const Point at = ab(bc.shift());
    return {at.x, at.y, wrappedAngle(ab.phi + bc.phi)};
  }
};

/** A transform made ready for many places: sine and cosine are taken once. */
class Motion2D {
 public:
  explicit Motion2D(const Transform2D& transform)
      : cos_(std::cos(transform.phi)), sin_(std::sin(transform.phi)), shift_(transform.shift()) {}

  /** The direction in a of a direction in b. */
  [[nodiscard]] Point turned(Point v) const {
    return {cos_ * v.x - sin_ * v.y, sin_ * v.x + cos_ * v.y};
  }
  /** The place in a of a place in b. */
  [[nodiscard]] Point operator()(Point p) const { return turned(p) + shift_; }

 private:
  double cos_, sin_;
  Point shift_;
};

/** The transform that turns by `phi` and carries `from` to `to`. */
[[nodiscard]] inline Transform2D carrying(Point from, Point to, double phi) {
  const Point shift = to - turned(from, phi);
  return {shift.x, shift.y, wrappedAngle(phi)};
}

}  // namespace roomgraph
