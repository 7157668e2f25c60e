#pragma once
#include <cmath>

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
  constexpr double kPlace = 0.02, kPlacePerRootMetre = 0.03;
  constexpr double kTurn = 0.003, kTurnPerRootMetre = 0.004, kTurnPerRootRadian = 0.01;
  const double way = norm(step.shift());
  const double turned = std::abs(step.phi);
  return {std::sqrt(kPlace * kPlace + kPlacePerRootMetre * kPlacePerRootMetre * way),
          std::sqrt(kTurn * kTurn + kTurnPerRootMetre * kTurnPerRootMetre * way +
                    kTurnPerRootRadian * kTurnPerRootRadian * turned)};
}

}  // namespace roomgraph
