#pragma once
#include <cmath>

#include "fitted_consensus.h"
#include "roomgraph/consensus/PoseGraph.h"

namespace roomgraph {

// The terms of docs/scoring.md, "The cost".

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
