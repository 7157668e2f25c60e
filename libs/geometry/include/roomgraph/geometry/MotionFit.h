#pragma once
#include <algorithm>
#include <cmath>

#include "roomgraph/geometry/PointSums.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** The turn and shift that carries places as near to others as one motion can, by least squares
 *  (Umeyama 1991, in the plane and without scale). */
class MotionFit {
 public:
  void add(Point from, Point to, double weight = 1) {
    from_ = from_ + weight * from, to_ = to_ + weight * to;
    cosine_ += weight * dot(from, to), sine_ += weight * cross(from, to);
    weight_ += weight;
    fromSquares_ += weight * squaredNorm(from), toSquares_ += weight * squaredNorm(to);
  }

  /** Adds points that one pose brings to the one places, and another one to the others. */
  void add(const PointSums& points, const Transform2D& from, const Transform2D& to) {
    const Point a = turned({points.x, points.y}, from.phi), p = from.shift();
    const Point b = turned({points.x, points.y}, to.phi), q = to.shift();
    const double turn = to.phi - from.phi, squares = points.xx + points.yy, n = points.count;
    weight_ += n;
    from_ = from_ + (a + n * p), to_ = to_ + (b + n * q);
    cosine_ += std::cos(turn) * squares + dot(a, q) + dot(p, b) + n * dot(p, q);
    sine_ += std::sin(turn) * squares + cross(a, q) + cross(p, b) + n * cross(p, q);
    fromSquares_ += squares + 2 * dot(a, p) + n * squaredNorm(p);
    toSquares_ += squares + 2 * dot(b, q) + n * squaredNorm(q);
  }

  [[nodiscard]] double weight() const { return weight_; }  ///< of all pairs together

  /** to <- from. Nothing where nothing was added; no turn where all places are one. */
  [[nodiscard]] Transform2D motion() const {
    if (weight_ <= 0) return {};
    return carrying(mean(from_), mean(to_), std::atan2(sine(), cosine()));
  }

  /** Root mean square of the distances that the motion leaves [m]; the farther off the places lie,
   *  the more it is rounded: 1e-8 of that. */
  [[nodiscard]] double rest() const {
    return root(spread(fromSquares_, from_) + spread(toSquares_, to_) -
                2 * std::hypot(cosine(), sine()));
  }

  /** Root mean square distance of the places to be carried from their middle [m]. */
  [[nodiscard]] double reach() const { return root(spread(fromSquares_, from_)); }

 private:
  [[nodiscard]] double spread(double squares, Point sum) const {
    return weight_ > 0 ? squares - weight_ * squaredNorm(mean(sum)) : 0;
  }
  [[nodiscard]] double root(double squares) const {
    return weight_ > 0 ? std::sqrt(std::max(0.0, squares / weight_)) : 0;
  }
  [[nodiscard]] Point mean(Point sum) const { return (1 / weight_) * sum; }
  [[nodiscard]] double cosine() const { return cosine_ - weight_ * dot(mean(from_), mean(to_)); }
  [[nodiscard]] double sine() const { return sine_ - weight_ * cross(mean(from_), mean(to_)); }

  Point from_, to_;
  double weight_ = 0, cosine_ = 0, sine_ = 0, fromSquares_ = 0, toSquares_ = 0;
};

}  // namespace roomgraph
