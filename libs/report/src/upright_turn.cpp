#include "roomgraph/report/upright_turn.h"

#include <cmath>

namespace roomgraph {

double uprightTurn(const std::vector<WallPoint>& walls, double heading) {
  // Four times an angle is the same for walls at right angles.
  double cosine = 0, sine = 0;
  for (const WallPoint& wall : walls) {
    const double angle = 4 * std::atan2(wall.normal.y, wall.normal.x);
    cosine += std::cos(angle), sine += std::sin(angle);
  }
  if (walls.empty() || std::hypot(cosine, sine) < 0.15 * double(walls.size())) return 0;
  const double turn = -std::remainder(std::atan2(sine, cosine) + 4 * heading, 2 * M_PI) / 4;
  return std::abs(turn) < M_PI / 180 ? 0 : turn;
}

double uprightTurn(const Comparison& comparison, const std::vector<Run>& runs) {
  for (const ComparedRun& compared : comparison.runs)
    if (const Run* run = findRun(runs, compared.name))
      return uprightTurn(run->map.walls, compared.pose.phi);
  return 0;
}

}  // namespace roomgraph
