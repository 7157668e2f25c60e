#include "upright_turn.h"

#include <cmath>

namespace roomgraph {
namespace {

constexpr double kWorthATurn = M_PI / 180;  // that is worth it [rad]
constexpr double kLeastInLine = 0.15;       // of the walls, that agree

}  // namespace

double uprightTurn(const PlacedMap& placed) {
  if (!placed.map || placed.map->walls.empty()) return 0;
  // Four times an angle is the same for walls at right angles.
  double cosine = 0, sine = 0;
  for (const WallPoint& wall : placed.map->walls) {
    const double angle = 4 * std::atan2(wall.normal.y, wall.normal.x);
    cosine += std::cos(angle), sine += std::sin(angle);
  }
  if (std::hypot(cosine, sine) < kLeastInLine * double(placed.map->walls.size())) return 0;
  const double turn = -std::remainder(std::atan2(sine, cosine) + 4 * placed.pose.phi, 2 * M_PI) / 4;
  return std::abs(turn) < kWorthATurn ? 0 : turn;
}

}  // namespace roomgraph
