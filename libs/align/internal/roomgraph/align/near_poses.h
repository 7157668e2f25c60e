#pragma once
#include <cmath>
#include <vector>

#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** How far apart two poses may lie, and still count as one. */
struct PoseTolerance {
  double turn = 0;   ///< [rad]
  double place = 0;  ///< of a place that both carry [m]
};

// All that the comparison takes for one pose, from the narrowest on. `alignment_accuracy` and
// `score_accuracy` of benchmarks/, each with `--data DIR`, show what a change does.
constexpr PoseTolerance kSameScanAnswer{0.02, 0.15};  ///< answers to where a scan or patch lies
constexpr PoseTolerance kSameStart{0.03, 0.3};        ///< starts of one search, and its first step
constexpr PoseTolerance kSameScanStart{0.05, 0.4};    ///< starts that one fit of a scan joins
constexpr PoseTolerance kNextPatch{0.08, 0.4};        ///< what a map bends from patch to patch
constexpr PoseTolerance kSteadyTrack{0.12, 0.6};      ///< what a map bends from scan to scan
constexpr PoseTolerance kSameAnswer{0.15, 1.0};       ///< answers to how two maps lie in each other
constexpr PoseTolerance kRoughly{0.3, 3.0};           ///< right before it is solved, or looked, for
constexpr PoseTolerance kAsMapsBend{0.45, 6.0};       ///< a pair beside its poses in the site

/** Whether two poses turn alike, and carry `place` to about the same one. */
inline bool areNear(const Transform2D& l, const Transform2D& r, Point place,
                    const PoseTolerance& within) {
  return std::abs(wrappedAngle(l.phi - r.phi)) < within.turn &&
         distance(l(place), r(place)) < within.place;
}

/** Whether this is so of one of several poses. */
inline bool isNearAny(const std::vector<Transform2D>& poses, const Transform2D& pose, Point place,
                      const PoseTolerance& within) {
  return anyOf(poses,
               [&](const Transform2D& other) { return areNear(other, pose, place, within); });
}

/** Of some that are sorted, the best first: up to `count` that are not the same as a better one. */
template <class Thing, class AreSame>
std::vector<Thing> distinctBest(const std::vector<Thing>& sorted, std::size_t count,
                                const AreSame& areSame) {
  std::vector<Thing> best;
  for (const Thing& thing : sorted) {
    if (best.size() == count) break;
    if (!anyOf(best, [&](const Thing& better) { return areSame(better, thing); }))
      best.push_back(thing);
  }
  return best;
}

}  // namespace roomgraph
