#include "roomgraph/report/upright_turn.h"

#include <cmath>

namespace roomgraph {

double uprightTurn(const WallMap& map, double heading) {
  if (!map.direction) return 0;
  const double turn = -std::remainder(*map.direction + heading, M_PI / 2);
  return std::abs(turn) < M_PI / 180 ? 0 : turn;
}

double uprightTurn(const Comparison& comparison, const std::vector<Run>& runs) {
  for (const ComparedRun& compared : comparison.runs)
    if (const Run* run = findRun(runs, compared.name))
      return uprightTurn(run->map, compared.pose.phi);
  return 0;
}

}  // namespace roomgraph
