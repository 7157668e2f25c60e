#include "drawn_building.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "sampled_grid.h"

namespace roomgraph::test {
namespace {

constexpr double kCell = 0.05, kWall = 0.1;

/** What a place of the building is, sampled into a map. */
Grid sampled(const std::function<State(Point)>& stateAt, const Transform2D& pose, Point low,
             Point high) {
  Point least{1e9, 1e9}, most{-1e9, -1e9};
  for (const Point corner : {low, high, Point{low.x, high.y}, Point{high.x, low.y}}) {
    const Point p = pose(corner);
    least = {std::min(least.x, p.x), std::min(least.y, p.y)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y)};
  }
  const GridFrame frame{int((most.x - least.x) / kCell) + 1, int((most.y - least.y) / kCell) + 1,
                        kCell, least};
  return sampledGrid(frame, [&, back = pose.inverse()](Point p) { return stateAt(back(p)); });
}

bool isAt(double value, double wall) { return std::abs(value - wall) <= kWall; }

/** One side of the corridor: where its walls stand, and its doors. */
struct Wing {
  std::vector<double> walls, doors;
};

Wing wing(std::mt19937& random, double width) {
  const auto number = [&](double low, double high) {
    return low + (high - low) * (double(random()) / 4294967296.0);
  };
  Wing w;
  for (double at = 0; at < width - 2;) {
    const double room = number(2.2, 6.5);
    w.doors.push_back(at + number(0.3, room - 1.2));
    at += room;
    w.walls.push_back(at);
  }
  return w;
}

bool isWallIn(const Wing& w, double along) {
  return std::any_of(w.walls.begin(), w.walls.end(), [&](double at) { return isAt(along, at); });
}

bool isDoorIn(const Wing& w, double along) {
  return std::any_of(w.doors.begin(), w.doors.end(),
                     [&](double at) { return along > at && along < at + 0.9; });
}

}  // namespace

Grid drawnBuilding(std::uint32_t seed, const Transform2D& pose, const Seen& seen) {
  std::mt19937 random(seed);
  const double width = 20 + 2 * double(seed % 4), height = 14 + double(seed % 5);
  const Wing lower = wing(random, width), upper = wing(random, width);
  const double low = 4 + double(seed % 3), high = low + 1.6 + 0.2 * double(seed % 6);
  return sampled(
      [&](Point p) {
        if (p.x < -kWall || p.x > width + kWall || p.y < -kWall || p.y > height + kWall)
          return State::unknown;
        if (p.x < seen.x0 || p.x > seen.x1) return State::unknown;
        if (isAt(p.x, 0) || isAt(p.x, width) || isAt(p.y, 0) || isAt(p.y, height))
          return State::occupied;
        if (isAt(p.y, low)) return isDoorIn(lower, p.x) ? State::free : State::occupied;
        if (isAt(p.y, high)) return isDoorIn(upper, p.x) ? State::free : State::occupied;
        if (p.y < low && isWallIn(lower, p.x)) return State::occupied;
        if (p.y > high && isWallIn(upper, p.x)) return State::occupied;
        return State::free;
      },
      pose, {-1, -1}, {width + 1, height + 1});
}

Grid squareHall(const Transform2D& pose) {
  return sampled(
      [](Point p) {
        const double far = std::max(std::abs(p.x), std::abs(p.y));
        if (far > 6 + kWall) return State::unknown;
        return isAt(far, 6) || far < 1 ? State::occupied : State::free;
      },
      pose, {-7, -7}, {7, 7});
}

Grid bent(const Grid& grid, double angle) {
  Grid result = grid;
  const GridFrame& f = grid.frame;
  const Point middle = f.center({f.width / 2, f.height / 2});
  for (int y = 0; y < f.height; ++y)
    for (int x = f.width / 2; x < f.width; ++x) {
      const Point from = turned(f.center({x, y}) - middle, -angle) + middle;
      result.cells[f.index({x, y})] = grid.atOrUnknown(f.cellAt(from));
    }
  return result;
}

Grid withTornEnd(const Grid& grid, Point about, double turn) {
  Grid result = grid;
  const Transform2D back = carrying(about, about, -turn);
  for (int y = 0; y < grid.frame.height; ++y)
    for (int x = 0; x < grid.frame.width; ++x) {
      const Point at = grid.frame.center({x, y});
      if (distance(at, about) > 3) continue;
      if (grid.atOrUnknown(grid.frame.cellAt(back(at))) == State::occupied)
        result.cells[grid.frame.index({x, y})] = State::occupied;
    }
  return result;
}

MapPairs related(const std::vector<Run>& runs, const KeptPairs& kept) {
  return relateRuns(runs, {}, oneByOne, kept);
}

}  // namespace roomgraph::test
