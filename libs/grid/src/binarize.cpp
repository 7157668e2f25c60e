#include "roomgraph/grid/binarize.h"

#include <array>

namespace roomgraph {
namespace {

/** What each of the 256 grey levels means. */
using StateOfGrey = std::array<State, 256>;

StateOfGrey paperStates(int blackThreshold) {
  StateOfGrey states;
  for (int grey = 0; grey < 256; ++grey)
    states[std::size_t(grey)] = 3 * grey <= blackThreshold ? State::occupied : State::free;
  return states;
}

StateOfGrey threeStates(double occupiedAbove, double freeBelow) {
  StateOfGrey states;
  for (int grey = 0; grey < 256; ++grey) {
    const double occupied = 1 - grey / 255.0;
    states[std::size_t(grey)] = occupied > occupiedAbove ? State::occupied
                                : occupied < freeBelow   ? State::free
                                                         : State::unknown;
  }
  return states;
}

/** Collects the patch of unknown cells (8 neighbours) that starts at `first`, up to `limit` cells.
 *  Returns whether all of it was collected and no wall or border touches it. */
bool collectSpeckle(const Grid& grid, Cell first, std::size_t limit, std::vector<Cell>& patch,
                    std::vector<bool>& isSeen) {
  patch.assign(1, first);
  isSeen[grid.frame.index(first)] = true;
  bool isFreeAround = true;
  for (std::size_t i = 0; i < patch.size(); ++i)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell near{patch[i].x + dx, patch[i].y + dy};
        if (!grid.frame.contains(near) || grid.at(near) == State::occupied) {
          isFreeAround = false;
        } else if (grid.at(near) == State::unknown && !isSeen[grid.frame.index(near)]) {
          isSeen[grid.frame.index(near)] = true;
          patch.push_back(near);
        }
      }
  return isFreeAround && patch.size() <= limit;
}

/** Beams that fan out leave single cells unseen; they are no obstacles to anybody. */
void fillSpeckles(Grid& grid, double maxArea) {
  const double cellArea = grid.frame.resolution * grid.frame.resolution;
  // The small addend makes the answer the same for areas that only rounding tells apart.
  const auto limit = std::size_t(maxArea / cellArea + 1e-9);
  if (limit == 0) return;
  std::vector<bool> isSeen(grid.cells.size());
  std::vector<Cell> patch;
  for (int y = 0; y < grid.frame.height; ++y)
    for (int x = 0; x < grid.frame.width; ++x) {
      const Cell cell{x, y};
      if (grid.at(cell) != State::unknown || isSeen[grid.frame.index(cell)]) continue;
      if (!collectSpeckle(grid, cell, limit, patch, isSeen)) continue;
      for (const Cell c : patch) grid.cells[grid.frame.index(c)] = State::free;
    }
}

}  // namespace

void describe(BinarizeOptions& options, FieldTable& table) {
  const char* section = "binarize";
  table.count(section, "black_threshold", options.blackThreshold, 0, 765,
              "A cell is occupied where R + G + B is at most this, all others are free; 0 for three "
              "states.");
  table.number(section, "occupied_above", options.occupiedAbove, "", 0, 1,
               "A cell is occupied above this probability; 0 for the threshold of the map's format.");
  table.number(section, "free_below", options.freeBelow, "", 0, 1,
               "A cell is free below this probability; 0 for the threshold of the map's format.");
  table.number(section, "max_unknown_speckle", options.maxUnknownSpeckle, "m2", 0, 1,
               "Unknown patches up to this size with free cells all round become free.");
}

Grid binarize(const GreyMap& map, const BinarizeOptions& options) {
  const StateOfGrey states =
      options.blackThreshold > 0
          ? paperStates(options.blackThreshold)
          : threeStates(options.occupiedAbove > 0 ? options.occupiedAbove : map.occupiedAbove,
                        options.freeBelow > 0 ? options.freeBelow : map.freeBelow);
  Grid grid{map.frame, std::vector<State>(map.grey.size())};
  for (std::size_t i = 0; i < map.grey.size(); ++i) grid.cells[i] = states[map.grey[i]];
  if (options.blackThreshold == 0) fillSpeckles(grid, options.maxUnknownSpeckle);
  return grid;
}

}  // namespace roomgraph
