#include "search_data.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

std::vector<double> turnsOf(const std::vector<WallPoint>& sides) {
  std::vector<double> turns(180, 0);
  for (const WallPoint& side : sides) {
    const double turn = std::atan2(side.normal.y, side.normal.x) / (2 * M_PI);
    turns[std::size_t((turn - std::floor(turn)) * double(turns.size())) % turns.size()] += 1;
  }
  return turns;
}

std::vector<std::uint32_t> freeCellsOf(const GridFrame& frame, const std::vector<State>& states) {
  const int step = std::max(1, int(std::lround(2 * kWallCell / frame.resolution)));
  std::vector<std::uint32_t> cells;
  for (int y = step / 2; y < frame.height; y += step)
    for (int x = step / 2; x < frame.width; x += step)
      if (states[frame.index({x, y})] == State::free)
        cells.push_back(std::uint32_t(frame.index({x, y})));
  return cells;
}

}  // namespace

void addSearchData(WallMap& map, const std::vector<WallPoint>& walls) {
  map.turns = turnsOf(walls);
  map.freeCells = freeCellsOf(map.frame, map.states);
  const auto free = std::count(map.states.begin(), map.states.end(), State::free);
  map.freeArea = double(free) * map.frame.resolution * map.frame.resolution;
}

}  // namespace roomgraph
