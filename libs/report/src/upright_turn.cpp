#include "roomgraph/report/upright_turn.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "roomgraph/align/wall_quality.h"

namespace roomgraph {
namespace {

constexpr double kAlike = M_PI / 60;  // directions that differ by less are those of parallel walls
constexpr double kLeastShare = 0.15;  // of the walls that have a direction in common

/** The directions along which most walls go, as one, up to quarter turns: the mean of the most that
 *  are alike. A building with a wing at another angle has one of the two, and not what lies
 *  between. None where few are alike. */
std::optional<double> mainDirection(std::vector<double> directions) {
  for (double& direction : directions) direction = std::remainder(direction, M_PI / 2);
  std::sort(directions.begin(), directions.end());
  const std::size_t count = directions.size();
  for (std::size_t i = 0; i < count; ++i) directions.push_back(directions[i] + M_PI / 2);
  std::size_t most = 0, from = 0, end = 0;
  for (std::size_t i = 0; i < count; ++i) {
    while (end < i + count && directions[end] <= directions[i] + kAlike) ++end;
    if (end - i > most) most = end - i, from = i;
  }
  if (count == 0 || double(most) < kLeastShare * double(count)) return std::nullopt;
  const auto first = directions.begin() + std::ptrdiff_t(from);
  return std::accumulate(first, first + std::ptrdiff_t(most), 0.0) / double(most);
}

}  // namespace

double uprightTurn(const std::vector<WallPoint>& walls, double heading) {
  const auto direction = mainDirection(wallDirections(walls));
  if (!direction) return 0;
  const double turn = -std::remainder(*direction + heading, M_PI / 2);
  return std::abs(turn) < M_PI / 180 ? 0 : turn;
}

double uprightTurn(const Comparison& comparison, const std::vector<Run>& runs) {
  for (const ComparedRun& compared : comparison.runs)
    if (const Run* run = findRun(runs, compared.name))
      return uprightTurn(run->map.walls, compared.pose.phi);
  return 0;
}

}  // namespace roomgraph
