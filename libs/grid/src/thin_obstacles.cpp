#include "roomgraph/grid/thin_obstacles.h"

#include <algorithm>

namespace roomgraph {
namespace {

/** Which cells are obstacles, the border repeated outwards. */
class Neighbourhood {
 public:
  Neighbourhood(const Grid& grid, bool unknownIsObstacle)
      : grid_(grid), unknownIsObstacle_(unknownIsObstacle) {}

  bool isObstacle(int x, int y) const {
    const GridFrame& frame = grid_.frame;
    const State state =
        grid_.at({std::clamp(x, 0, frame.width - 1), std::clamp(y, 0, frame.height - 1)});
    return state == State::occupied || (unknownIsObstacle_ && state == State::unknown);
  }
  bool isEnclosedBy4(int x, int y) const {
    return isObstacle(x - 1, y) && isObstacle(x + 1, y) && isObstacle(x, y - 1) &&
           isObstacle(x, y + 1);
  }
  bool isEnclosedBy8(int x, int y) const {
    return isEnclosedBy4(x, y) && isObstacle(x - 1, y - 1) && isObstacle(x + 1, y - 1) &&
           isObstacle(x - 1, y + 1) && isObstacle(x + 1, y + 1);
  }

 private:
  const Grid& grid_;
  bool unknownIsObstacle_;
};

}  // namespace

void describe(ThinObstaclesOptions& options, FieldTable& table) {
  const char* section = "thin_obstacles";
  table.choice(section, "neighbours", options.neighbours, {"none", "4", "8"},
               "An obstacle cell whose 4 or 8 neighbours are all obstacles is dropped.");
  table.flag(section, "unknown_is_obstacle", options.unknownIsObstacle,
             "Unknown cells bound the free space as walls do, so that no path leads through them.");
}

std::vector<std::uint8_t> thinObstacles(const Grid& grid, const ThinObstaclesOptions& options) {
  const Neighbourhood near(grid, options.unknownIsObstacle);
  const bool useFour = options.neighbours == "4", useEight = options.neighbours == "8";
  std::vector<std::uint8_t> kept(grid.cells.size());
  for (int y = 0; y < grid.frame.height; ++y)
    for (int x = 0; x < grid.frame.width; ++x) {
      const bool isEnclosed =
          (useFour && near.isEnclosedBy4(x, y)) || (useEight && near.isEnclosedBy8(x, y));
      kept[grid.frame.index({x, y})] = near.isObstacle(x, y) && !isEnclosed;
    }
  return kept;
}

}  // namespace roomgraph
