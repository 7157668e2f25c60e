#pragma once
#include <cmath>

#include "fitted_consensus.h"
#include "roomgraph/consensus/PoseGraph.h"
#include "roomgraph/consensus/belief.h"

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

// The terms of docs/method.md, "The cost".

/** How an edge counts: residuals are in units of `noise`; beyond `width` of these the Cauchy kernel
 *  lets go. */
struct EdgeTerm {
  PoseNoise noise;
  double width = 1, weight = 1;

  /** Half of the robust squared residual, as in Ceres. */
  double cost(const PoseGap& gap) const {
    const double place = gap.place / noise.place, turn = gap.turn / noise.turn;
    const double squares = place * place + turn * turn, wide = width * width;
    return weight * wide * std::log1p(squares / wide) / 2;
  }
};

/** A link holds its nodes together as far as its run's `slack` allows. */
inline EdgeTerm linkTerm(const PoseEdge& link, double slack) {
  return {link.noise.times(slack), fitted::kLinkWidth, link.share};
}

/** Half the robust squared residual of a link from which on it gave way. */
constexpr double kGaveWay = 10;

/** What a link costs more whose nodes lie farther apart than its robot goes in one step: to give
 *  way may have mended a tear, to leap has not. */
inline double costOfLeap(const PoseEdge& link, double apart) {
  return apart > link.reach ? kGaveWay : 0;
}

/** A match lays its nodes on each other as far as its group is believed. */
inline EdgeTerm matchTerm(const PoseEdge& match, double belief) {
  return {match.noise, fitted::kMatchWidth,
          belief * match.share * (match.isSameScan ? 2 : 1) * fitted::kMatchWeight};
}

/** Either, in a graph that is trusted so far. */
inline EdgeTerm termOf(const PoseGraph& graph, const PoseEdge& edge, const GraphTrust& trust) {
  return edge.group ? matchTerm(edge, trust.belief[edge.group])
                    : linkTerm(edge, trust.slack[graph.runOf(edge.from)]);
}

/** Whether an edge takes part in the solution. Groups that are given up would join look-alike
 *  places all with all, which takes most of the time and moves nothing. */
inline bool takesPart(const PoseEdge& edge, const GraphTrust& trust) {
  const bool isOfOneNode = edge.from == edge.to;  // of a coarse graph: as it was found in itself
  return !isOfOneNode && (!edge.group || trust.belief[edge.group] > kGivenUp);
}

/** The information of a measured pose, the inverse of its variances [1/rad^2, 1/m^2]. */
struct PoseInformation {
  double turn = 0, place = 0;
};

/** What an edge still says at `poses`, as the last step of the solution weighs it: next to nothing
 *  where it contradicts the rest. */
inline PoseInformation informationOf(const PoseGraph& graph, const PoseEdge& edge,
                                     const GraphTrust& trust, const NodePoses& poses) {
  const EdgeTerm term = termOf(graph, edge, trust);
  const PoseGap gap = gapOf(edge, poses);
  const double place = gap.place / term.noise.place, turn = gap.turn / term.noise.turn;
  const double left = 1 / (1 + (place * place + turn * turn) / (term.width * term.width));
  const double weight = term.weight * left;
  return {weight / (term.noise.turn * term.noise.turn),
          weight / (term.noise.place * term.noise.place)};
}

}  // namespace roomgraph
