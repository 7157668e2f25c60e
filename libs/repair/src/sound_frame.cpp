#include "roomgraph/repair/sound_frame.h"

#include <algorithm>
#include <cmath>

#include "fitted_repair.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/geometry/MotionFit.h"
#include "roomgraph/relate/turn_lever.h"

namespace roomgraph {
namespace {

std::vector<double> distances(const std::vector<Transform2D>& were,
                              const std::vector<Transform2D>& real, const Transform2D& frame) {
  std::vector<double> all;
  for (std::size_t k = 0; k < were.size(); ++k)
    all.push_back(poseDistance(were[k], frame * real[k]));
  return all;
}

/** The best frame for poses up to `most` apart. */
Transform2D fitFrame(const std::vector<Transform2D>& were, const std::vector<Transform2D>& real,
                     const std::vector<double>& apart, double most) {
  MotionFit fit;
  for (std::size_t k = 0; k < were.size(); ++k) {
    if (apart[k] > most) continue;
    for (const Point round :
         {Point{kTurnLever, 0}, Point{-kTurnLever, 0}, Point{0, kTurnLever}, Point{0, -kTurnLever}})
      fit.add(real[k](round), were[k](round));
  }
  return fit.motion();
}

}  // namespace

double poseDistance(const Transform2D& l, const Transform2D& r) {
  return std::hypot(distance(l.shift(), r.shift()), kTurnLever * 2 * std::sin((l.phi - r.phi) / 2));
}

Transform2D soundFrame(const std::vector<Transform2D>& were, const std::vector<Transform2D>& real) {
  Transform2D best;
  double least = HUGE_VAL;
  const std::size_t step = were.size() / fitted::kProbes + 1;
  for (std::size_t k = 0; k < were.size(); k += step) {
    const Transform2D frame = were[k] * real[k].inverse();
    const double middle = median(distances(were, real, frame));
    if (middle < least) best = frame, least = middle;
  }
  for (int round = 0; round < 3 && !were.empty(); ++round) {
    const std::vector<double> apart = distances(were, real, best);
    best = fitFrame(were, real, apart, std::max(fitted::kWithin * median(apart), 1e-9));
  }
  return best;
}

}  // namespace roomgraph
