#include "gait.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/base/statistics.h"

namespace roomgraph {

Gait::Gait(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& poses) {
  std::vector<double> ways{0}, ahead{0}, turns{0}, speeds{0};
  for (std::size_t k = 1; k < poses.size(); ++k) {
    const Transform2D step = poses[k - 1].inverse() * poses[k];
    ways.push_back(norm(step.shift()));
    ahead.push_back(step.x);
    turns.push_back(std::abs(step.phi));
    if (const double time = secondsTo(scans, k); time > 0) speeds.push_back(ways.back() / time);
  }
  back = std::min(0.0, quantile(ahead, 0.02) - 0.5);
  longest = {1.3 * quantile(turns, 0.98) + 0.2, 1.3 * quantile(ways, 0.98) + 0.5};
  speed = 1.3 * quantile(speeds, 0.98);
}

double Gait::secondsTo(const std::vector<LocalScan>& scans, std::size_t k) {
  if (!scans[k].time || !scans[k - 1].time) return 0;
  return *scans[k].time - *scans[k - 1].time;
}

bool Gait::isInReach(const Transform2D& step, double seconds) const {
  return norm(step.shift()) < reachIn(seconds) && std::abs(step.phi) < longest.turn;
}

bool Gait::isPossible(const Transform2D& step, double seconds) const {
  return isLikely(step, seconds) || (std::abs(step.phi) > M_PI_4 && isInReach(step, seconds));
}

bool Gait::isLikely(const Transform2D& step, double seconds) const {
  const double farthestBack = std::min(back, longest.place - reachIn(seconds));
  return seconds < 0 || (isInReach(step, seconds) && step.x > farthestBack);
}

}  // namespace roomgraph
