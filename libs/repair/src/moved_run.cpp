#include "moved_run.h"

#include <cmath>

#include "roomgraph/repair/sound_frame.h"

namespace roomgraph {

std::vector<KeyFrames> unseenIn(const Run& run, const std::vector<bool>& isSeen) {
  std::vector<KeyFrames> stretches;
  for (std::size_t k = 0; k < run.scans.size(); ++k) {
    if (isSeen[k]) continue;
    if (k == 0 || isSeen[k - 1]) stretches.push_back({run.scans[k].keyFrame, 0});
    stretches.back().to = run.scans[k].keyFrame;
  }
  return stretches;
}

void moveTo(const std::vector<Transform2D>& real, const Run& run, RepairedRun& repaired) {
  double squares = 0;
  for (std::size_t k = 0; k < real.size(); ++k) {
    repaired.poses[k] = repaired.frame * real[k];
    const double apart = poseDistance(run.scans[k].pose, repaired.poses[k]);
    squares += apart * apart;
    if (apart <= repaired.movedMost) continue;
    repaired.movedMost = apart, repaired.movedMostAt = run.scans[k].keyFrame;
  }
  repaired.moved = std::sqrt(squares / double(real.size()));
}

PlanarCovariance turned(const PlanarCovariance& covariance, double angle) {
  const auto& [xx, yy, pp, xy, xp, yp] = covariance;
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * c * xx - 2 * c * s * xy + s * s * yy,
          s * s * xx + 2 * c * s * xy + c * c * yy,
          pp,
          c * s * (xx - yy) + (c * c - s * s) * xy,
          c * xp - s * yp,
          s * xp + c * yp};
}

}  // namespace roomgraph
