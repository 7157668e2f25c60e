#pragma once
#include <cmath>

#include "roomgraph/consensus/PoseGraph.h"

namespace roomgraph {

/** A pose with its sine and cosine: where poses lie to each other is asked so often that to take
 *  these anew each time is most of the work. */
struct TurnedPose {
  Point shift;
  double phi = 0, cos = 1, sin = 0;

  TurnedPose() = default;
  explicit TurnedPose(const Transform2D& pose)
      : shift(pose.shift()), phi(pose.phi), cos(std::cos(phi)), sin(std::sin(phi)) {}

  /** (a <- b) * (b <- c) = a <- c; its `phi` is not wrapped. */
  TurnedPose operator*(const TurnedPose& bc) const {
    TurnedPose ac;
    ac.shift =
        Point{cos * bc.shift.x - sin * bc.shift.y, sin * bc.shift.x + cos * bc.shift.y} + shift;
    ac.phi = phi + bc.phi;
    ac.cos = cos * bc.cos - sin * bc.sin, ac.sin = sin * bc.cos + cos * bc.sin;
    return ac;
  }

  /** How far another pose lies from where an edge that leads from this one has it. */
  PoseGap gapOf(const PoseEdge& edge, const TurnedPose& to) const {
    const Point d = to.shift - shift;
    const Point found{cos * d.x + sin * d.y, cos * d.y - sin * d.x};
    return {std::abs(wrappedAngle(to.phi - phi - edge.measured.phi)),
            distance(found, edge.measured.shift())};
  }
};

}  // namespace roomgraph
