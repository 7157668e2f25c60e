#include "straight_pieces.h"

#include <algorithm>
#include <utility>

namespace roomgraph {
namespace {

/** The point between two others that is farthest from their straight line, and how far. */
std::pair<std::size_t, double> farthest(const Polyline& line, std::size_t from, std::size_t to) {
  std::pair<std::size_t, double> best{from, 0};
  for (std::size_t i = from + 1; i < to; ++i) {
    const double d = distanceToSegment(line[i], line[from], line[to]);
    if (d > best.second) best = {i, d};
  }
  return best;
}

}  // namespace

std::vector<std::size_t> straightPieces(const Path& path, const ObstacleRows& obstacles,
                                        double clearance) {
  const Polyline& line = path.points;
  if (line.empty()) return {};
  const double tolerance = std::min(0.1, path.minClearance / 2);
  std::vector<bool> isKept(line.size());
  isKept.front() = isKept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
  if (line.front() == line.back()) {
    // The place farthest away splits a loop; without a second one it would be there and back.
    const std::size_t turn = farthest(line, 0, line.size() - 1).first;
    open = {{0, turn}, {turn, line.size() - 1}};
    isKept[turn] = true;
    const auto a = farthest(line, 0, turn), b = farthest(line, turn, line.size() - 1);
    isKept[a.second >= b.second ? a.first : b.first] = true;
  }
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    const auto [bend, deviation] = farthest(line, from, to);
    if (bend == from ||
        (deviation <= tolerance && obstacles.isClear(line[from], line[to], clearance)))
      continue;
    isKept[bend] = true;
    open.push_back({from, bend});
    open.push_back({bend, to});
  }
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (isKept[i]) kept.push_back(i);
  return kept;
}

}  // namespace roomgraph
