#pragma once
#include <vector>

#include "roomgraph/grid/Grid.h"

namespace roomgraph::test {

/** A map whose cells are what `stateAt` says of their centres. */
template <class StateAt>
Grid sampledGrid(const GridFrame& frame, const StateAt& stateAt) {
  Grid grid{frame, {}};
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) grid.cells.push_back(stateAt(frame.center({x, y})));
  return grid;
}

/** The map with each cell as `cellAt` says. */
template <class CellAt>
Grid redrawn(Grid grid, const CellAt& cellAt) {
  std::vector<State> cells;
  for (int y = 0; y < grid.frame.height; ++y)
    for (int x = 0; x < grid.frame.width; ++x) cells.push_back(cellAt(Cell{x, y}));
  grid.cells = cells;
  return grid;
}

/** The centres of its occupied cells. */
inline std::vector<Point> occupiedPlaces(const Grid& grid) {
  std::vector<Point> places;
  for (const Cell c : grid.frame.cellsWhere([&](Cell c) { return grid.at(c) == State::occupied; }))
    places.push_back(grid.frame.center(c));
  return places;
}

}  // namespace roomgraph::test
