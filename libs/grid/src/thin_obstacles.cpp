#include "roomgraph/grid/thin_obstacles.h"

#include <algorithm>

namespace roomgraph {
namespace {

using Flags = std::vector<std::uint8_t>;

/** Which cells of row `y` are obstacles; the border is repeated outwards, by one cell on each side
 *  and beyond the first and the last row. */
void fillRow(const Grid& grid, int y, bool unknownIsObstacle, Flags& row) {
  const State* cells =
      grid.cells.data() + grid.frame.index({0, std::clamp(y, 0, grid.frame.height - 1)});
  const auto width = std::size_t(grid.frame.width);
  for (std::size_t x = 0; x < width; ++x)
    row[x + 1] = (cells[x] == State::occupied) | (unknownIsObstacle & (cells[x] == State::unknown));
  row.front() = row[1];
  row.back() = row[width];
}

/** No branch within, so that the compiler takes many cells at once. */
void keepOf(const Flags& below, const Flags& here, const Flags& above, bool useFour, bool useEight,
            std::uint8_t* kept) {
  const std::uint8_t four = useFour || useEight, eight = useEight;
  for (std::size_t x = 1; x + 1 < here.size(); ++x) {
    const std::uint8_t sides = here[x - 1] & here[x + 1] & below[x] & above[x];
    const std::uint8_t corners = below[x - 1] & below[x + 1] & above[x - 1] & above[x + 1];
    kept[x - 1] = here[x] & ~(four & sides & (corners | (eight ^ 1)));
  }
}

}  // namespace

void describe(ThinObstaclesOptions& options, FieldTable& table) {
  const char* section = "thin_obstacles";
  table.choice(section, "neighbours", options.neighbours, {"none", "4", "8"},
               "An obstacle cell whose 4 or 8 neighbours are all obstacles is dropped.");
  table.flag(section, "unknown_is_obstacle", options.unknownIsObstacle,
             "Unknown cells bound the free space as walls do, so that no path leads through them.");
}

std::vector<std::uint8_t> thinObstacles(const Grid& grid, const ThinObstaclesOptions& options) {
  const bool useFour = options.neighbours == "4", useEight = options.neighbours == "8";
  std::vector<std::uint8_t> kept(grid.cells.size());
  const auto padded = std::size_t(grid.frame.width) + 2;
  Flags below(padded), here(padded), above(padded);
  for (int y = 0; y < grid.frame.height; ++y) {
    if (y == 0) fillRow(grid, 0, options.unknownIsObstacle, here), below = here;
    fillRow(grid, y + 1, options.unknownIsObstacle, above);
    keepOf(below, here, above, useFour, useEight, kept.data() + grid.frame.index({0, y}));
    std::swap(below, here), std::swap(here, above);
  }
  return kept;
}

}  // namespace roomgraph
