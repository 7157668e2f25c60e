#include "roomgraph/consensus/gait.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "roomgraph/base/statistics.h"

namespace roomgraph {

Gait::Gait(const std::vector<Transform2D>& poses, std::vector<std::optional<double>> times)
    : times_(std::move(times)) {
  std::vector<double> ways{0}, ahead{0}, turns{0}, speeds{0}, spins{0};
  for (std::size_t k = 1; k < poses.size(); ++k) {
    const Transform2D step = poses[k - 1].inverse() * poses[k];
    ways.push_back(norm(step.shift()));
    ahead.push_back(step.x);
    turns.push_back(std::abs(step.phi));
    if (const double time = secondsTo(k); time > 0)
      speeds.push_back(ways.back() / time), spins.push_back(turns.back() / time);
  }
  back = std::min(0.0, quantile(ahead, 0.02) - 0.5);
  longest = {1.3 * quantile(turns, 0.98) + 0.2, 1.3 * quantile(ways, 0.98) + 0.5};
  fastest = {1.3 * quantile(spins, 0.98), 1.3 * quantile(speeds, 0.98)};
}

double Gait::secondsTo(std::size_t k) const {
  if (!times_[k] || !times_[k - 1]) return 0;
  return *times_[k] - *times_[k - 1];
}

double Gait::reachTo(std::size_t k) const {
  const double seconds = secondsTo(k);
  return seconds < 0 ? std::numeric_limits<double>::infinity()
                     : std::max(longest.place, seconds * fastest.place);
}

bool Gait::isInReach(const Transform2D& step, std::size_t k) const {
  const double turn = std::max(longest.turn, secondsTo(k) * fastest.turn);
  return norm(step.shift()) < reachTo(k) && std::abs(step.phi) < turn;
}

bool Gait::isPossible(const Transform2D& step, std::size_t k) const {
  return isLikely(step, k) || (std::abs(step.phi) > M_PI_4 && isInReach(step, k));
}

bool Gait::isLikely(const Transform2D& step, std::size_t k) const {
  const double farthestBack = std::min(back, longest.place - reachTo(k));
  return secondsTo(k) < 0 || (isInReach(step, k) && step.x > farthestBack);
}

}  // namespace roomgraph
