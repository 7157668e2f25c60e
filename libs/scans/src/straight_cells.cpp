#include "straight_cells.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace roomgraph {
namespace {

constexpr int kTurns = 36;     // directions of half a turn
constexpr int kShortest = 10;  // of a piece [cells]
constexpr int kWidestGap = 2;  // in a piece [cells]
constexpr int kThickest = 3;   // across a piece [cells]

/** A cell by the line of a direction that it is on, and how far along. */
struct Seen {
  std::int32_t line = 0, along = 0;
  std::uint32_t cell = 0;
};

/** Sets run[i] to the length of the piece that cell i is part of in the direction. */
void measureRuns(const std::vector<Cell>& cells, double angle, std::vector<std::int32_t>& run) {
  const double c = std::cos(angle), s = std::sin(angle);
  std::vector<Seen> seen(cells.size());
  for (std::uint32_t i = 0; i < cells.size(); ++i)
    seen[i] = {std::int32_t(std::lround(c * cells[i].y - s * cells[i].x)),
               std::int32_t(std::lround(c * cells[i].x + s * cells[i].y)), i};
  std::sort(seen.begin(), seen.end(), [](const Seen& l, const Seen& r) {
    return std::tie(l.line, l.along, l.cell) < std::tie(r.line, r.along, r.cell);
  });
  for (std::size_t first = 0, i = 0; i < seen.size(); ++i) {
    const bool isLast = i + 1 == seen.size() || seen[i + 1].line != seen[i].line ||
                        seen[i + 1].along - seen[i].along > kWidestGap + 1;
    if (!isLast) continue;
    const std::int32_t length = seen[i].along - seen[first].along + 1;
    for (; first <= i; ++first) run[seen[first].cell] = length;
  }
}

}  // namespace

std::size_t countStraightCells(std::vector<Cell> cells) {
  const auto key = [](Cell c) { return std::make_pair(c.y, c.x); };
  std::sort(cells.begin(), cells.end(), [&](Cell l, Cell r) { return key(l) < key(r); });
  cells.erase(
      std::unique(cells.begin(), cells.end(), [&](Cell l, Cell r) { return key(l) == key(r); }),
      cells.end());
  // By half turns: across direction k is direction k + kTurns / 2.
  std::vector<std::vector<std::int32_t>> runs(kTurns);
  for (int k = 0; k < kTurns; ++k) {
    runs[std::size_t(k)].resize(cells.size());
    measureRuns(cells, M_PI * k / kTurns, runs[std::size_t(k)]);
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::size_t longest = 0;
    for (std::size_t k = 1; k < kTurns; ++k)
      if (runs[k][i] > runs[longest][i]) longest = k;
    const std::int32_t across = runs[(longest + kTurns / 2) % kTurns][i];
    count += runs[longest][i] >= kShortest && across <= kThickest;
  }
  return count;
}

}  // namespace roomgraph
