#pragma once
#include <cmath>

#include "fitted_consensus.h"
#include "roomgraph/consensus/run_submaps.h"

namespace roomgraph {

/** Standard deviations of a measured pose [m, rad]. */
struct LinkNoise {
  double place = 0, turn = 0;

  LinkNoise times(double factor) const { return {factor * place, factor * turn}; }
};

/** The pose that a link is to keep: from <- to. */
inline Transform2D stepOf(const RunSubmaps& run, const SubmapLink& link) {
  return run.submaps[link.from].pose.inverse() * run.submaps[link.to].pose;
}

/** How far a step of an ordinary run is off: some for each key frame, and more for way and turn. */
inline LinkNoise linkNoise(const Transform2D& step) {
  const double way = norm(step.shift());
  const double turned = std::abs(step.phi);
  const auto squared = [](double x) { return x * x; };
  return {std::sqrt(squared(fitted::kLinkPlace) + squared(fitted::kLinkPlacePerRootMetre) * way),
          std::sqrt(squared(fitted::kLinkTurn) + squared(fitted::kLinkTurnPerRootMetre) * way +
                    squared(fitted::kLinkTurnPerRootRadian) * turned)};
}

}  // namespace roomgraph
