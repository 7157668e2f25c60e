#pragma once
#include <string>
#include <vector>

#include "roomgraph/grid/Grid.h"

namespace roomgraph::test {

/** Rows from top to bottom; '#' occupied, '.' free, '?' unknown. */
inline Grid gridFrom(const std::vector<std::string>& rows, double resolution = 0.1) {
  Grid grid;
  grid.frame = {int(rows.front().size()), int(rows.size()), resolution, {1, 2}};
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    for (const char cell : *row)
      grid.cells.push_back(cell == '#'   ? State::occupied
                           : cell == '.' ? State::free
                                         : State::unknown);
  return grid;
}

}  // namespace roomgraph::test
