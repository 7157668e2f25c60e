#pragma once
#include <algorithm>
#include <cmath>

#include "roomgraph/align/scan_walls.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** Sums over places in two frames, so that the best motion from one to the other and what it
 *  leaves over follow (Umeyama 1991). */
class Displacement {
 public:
  /** Adds points of a node that lies at `from` in the one frame and at `to` in the other. */
  void add(const PointSums& points, const Transform2D& from, const Transform2D& to) {
    const Moved a(points, from), b(points, to);
    weight_ += points.count;
    from_ = from_ + a.sum, to_ = to_ + b.sum;
    const double turn = to.phi - from.phi, c = std::cos(turn), s = std::sin(turn);
    const double squares = points.xx + points.yy;
    const Point p = from.shift(), q = to.shift();
    const double n = points.count;
    cosine_ += c * squares + dot(a.turned, q) + dot(p, b.turned) + n * dot(p, q);
    sine_ += s * squares + cross(a.turned, q) + cross(p, b.turned) + n * cross(p, q);
    fromSquares_ += squares + 2 * dot(a.turned, p) + n * squaredNorm(p);
    toSquares_ += squares + 2 * dot(b.turned, q) + n * squaredNorm(q);
  }

  double weight() const { return weight_; }

  Transform2D motion() const {
    if (weight_ <= 0) return {};
    return carrying((1 / weight_) * from_, (1 / weight_) * to_, std::atan2(sine(), cosine()));
  }

  /** Root mean square of what the best motion leaves over [m]. */
  double rest() const {
    return root(spread(fromSquares_, from_) + spread(toSquares_, to_) -
                2 * std::hypot(cosine(), sine()));
  }

  /** Root mean square distance of the places in the first frame from their middle [m]. */
  double reach() const { return root(spread(fromSquares_, from_)); }

 private:
  struct Moved {
    Point turned, sum;
    Moved(const PointSums& points, const Transform2D& pose)
        : turned(roomgraph::turned({points.x, points.y}, pose.phi)),
          sum(turned + points.count * pose.shift()) {}
  };

  double spread(double squares, Point sum) const {
    return weight_ > 0 ? squares - squaredNorm(sum) / weight_ : 0;
  }
  double root(double squares) const {
    return weight_ > 0 ? std::sqrt(std::max(0.0, squares / weight_)) : 0;
  }
  double cosine() const { return cosine_ - dot(from_, to_) / weight_; }
  double sine() const { return sine_ - cross(from_, to_) / weight_; }

  double weight_ = 0, cosine_ = 0, sine_ = 0, fromSquares_ = 0, toSquares_ = 0;
  Point from_, to_;
};

}  // namespace roomgraph
