#pragma once
#include <cmath>

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
  }

  [[nodiscard]] double weight() const { return weight_; }  ///< of all pairs together

  /** to <- from. Nothing where nothing was added; no turn where all places are one. */
  [[nodiscard]] Transform2D motion() const {
    if (weight_ <= 0) return {};
    const Point from = (1 / weight_) * from_, to = (1 / weight_) * to_;
    const double cosine = cosine_ - weight_ * dot(from, to);
    const double sine = sine_ - weight_ * cross(from, to);
    return carrying(from, to, std::atan2(sine, cosine));
  }

 private:
  Point from_, to_;
  double cosine_ = 0, sine_ = 0, weight_ = 0;
};

}  // namespace roomgraph
