#pragma once
#include <cmath>

#include "link_noise.h"
#include "roomgraph/consensus/match_submaps.h"

namespace roomgraph {

/** What the pose graph says of two submaps: where the one lies in the other, how exactly, and how
 *  much that counts. Residuals are in units of `noise`; beyond `width` of these the Cauchy kernel
 *  lets go. */
struct GraphTerm {
  Transform2D measured;
  LinkNoise noise;
  double width = 1, weight = 1;

  /** Half of the robust squared residual, as in Ceres, of a submap at `to` seen from one at `from`
   *  [site <- submap]. */
  double cost(const Transform2D& from, const Transform2D& to) const {
    return cost(from.inverse() * to);
  }

  /** The same of submaps that lie to each other as `found`. */
  double cost(const Transform2D& found) const {
    const double place = distance(found.shift(), measured.shift()) / noise.place;
    const double turn = wrappedAngle(found.phi - measured.phi) / noise.turn;
    const double squares = place * place + turn * turn, wide = width * width;
    return weight * wide * std::log1p(squares / wide) / 2;
  }
};

// The terms of docs/scoring.md, "The cost".

/** A link holds its submaps together, as far as its run's `slack` allows. */
inline GraphTerm linkTerm(const RunSubmaps& run, const SubmapLink& link, double slack) {
  const Transform2D step = stepOf(run, link);
  return {step, linkNoise(step).times(slack), fitted::kLinkWidth, 1};
}

/** A match lays two submaps of different runs on each other, as far as its piece is believed. */
inline GraphTerm matchTerm(const SubmapMatch& match, double belief) {
  constexpr LinkNoise kNoise{fitted::kMatchPlace, fitted::kMatchTurn};
  constexpr LinkNoise kSameScanNoise{fitted::kSameScanPlace, fitted::kSameScanTurn};
  return {
      match.pose, match.isSameScan ? kSameScanNoise : kNoise, fitted::kMatchWidth,
      belief * match.weight * (match.isSameScan ? fitted::kSameScanWeight : fitted::kMatchWeight)};
}

}  // namespace roomgraph
