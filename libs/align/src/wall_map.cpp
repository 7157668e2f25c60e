#include "roomgraph/align/wall_map.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/align/wall_quality.h"
#include "roomgraph/grid/CellBox.h"
#include "roomgraph/grid/clear_wall_rims.h"

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

constexpr double kNormalRadius = 0.25;  // of the window that gives a wall its direction [m]

/** What lies in each cell of one row of a coarser map. */
class CoarseRow {
 public:
  explicit CoarseRow(const GridFrame& frame)
      : balance_(std::size_t(frame.width)), isOccupied_(std::size_t(frame.width)) {}

  void add(std::size_t column, State state) {
    if (state == State::occupied) isOccupied_[column] = 1;
    balance_[column] += state == State::free ? 1 : -1;
  }

  /** Writes the row, and starts anew. */
  void moveTo(Grid& grid, int row) {
    State* cells = &grid.cells[grid.frame.index({0, row})];
    for (std::size_t x = 0; x < balance_.size(); ++x)
      cells[x] = isOccupied_[x] ? State::occupied : balance_[x] > 0 ? State::free : State::unknown;
    std::fill(balance_.begin(), balance_.end(), 0);
    std::fill(isOccupied_.begin(), isOccupied_.end(), std::uint8_t(0));
  }

 private:
  std::vector<std::int32_t> balance_;  // free cells less the others
  std::vector<std::uint8_t> isOccupied_;
};

/** From the occupied cells round a free cell towards it; (0, 0) where they balance. */
Point normalAt(const Grid& grid, Cell cell) {
  const int r = std::max(1, int(kNormalRadius / grid.frame.resolution));
  Point sum;
  for (int y = std::max(0, cell.y - r); y <= std::min(grid.frame.height - 1, cell.y + r); ++y)
    for (int x = std::max(0, cell.x - r); x <= std::min(grid.frame.width - 1, cell.x + r); ++x)
      if (grid.at({x, y}) == State::occupied) {
        const double dx = cell.x - x, dy = cell.y - y;
        if (dx * dx + dy * dy > r * r) continue;
        const double weight = 1 / (dx * dx + dy * dy);
        sum = sum + weight * Point{dx, dy};
      }
  const double length = norm(sum);
  return length < 1e-9 ? Point{} : (1 / length) * sum;
}

/** Every free cell beside a wall. */
std::vector<WallPoint> wallSides(const Grid& grid) {
  std::vector<WallPoint> sides;
  for (int y = 0; y < grid.frame.height; ++y)
    for (int x = 0; x < grid.frame.width; ++x) {
      if (grid.at({x, y}) != State::free) continue;
      if (grid.countBeside({x, y}, State::occupied) == 0) continue;
      const Point normal = normalAt(grid, {x, y});
      if (normal == Point{}) continue;
      sides.push_back({grid.frame.center({x, y}) - 0.5 * grid.frame.resolution * normal, normal});
    }
  return sides;
}

/** The mean of the sides in each cell and octant, by cell, then octant. */
std::vector<WallPoint> thinned(const std::vector<WallPoint>& sides, const GridFrame& frame) {
  std::vector<std::pair<std::size_t, std::size_t>> order;  // key, side
  for (std::size_t i = 0; i < sides.size(); ++i)
    order.push_back({frame.index(frame.cellAt(sides[i].place)) * kOctants +
                         std::size_t(octantOf(sides[i].normal)),
                     i});
  std::sort(order.begin(), order.end());
  std::vector<WallPoint> points;
  for (std::size_t i = 0; i < order.size();) {
    Point place, normal;
    std::size_t n = 0, k = i;
    for (; k < order.size() && order[k].first == order[i].first; ++k, ++n) {
      place = place + sides[order[k].second].place;
      normal = normal + sides[order[k].second].normal;
    }
    normal = (1 / norm(normal)) * normal;  // within one octant, so not (0, 0)
    points.push_back({(1 / double(n)) * place, normal});
    i = k;
  }
  return points;
}

bool isWallEdge(const Grid& grid, Cell c) {
  return grid.at(c) == State::occupied && grid.countBeside(c, State::occupied) < 4;
}

DrawnEdges edgesOf(const Grid& grid) {
  const CellBox known = knownCells(grid);
  const GridFrame& from = grid.frame;
  DrawnEdges edges;
  if (known.isEmpty()) return edges;
  edges.frame.resolution = from.resolution;
  edges.frame.origin =
      from.origin + from.resolution * Point{double(known.low.x), double(known.low.y)};
  edges.frame.width = known.width(), edges.frame.height = known.height();
  for (int y = known.low.y; y <= known.high.y; ++y)
    for (int x = known.low.x; x <= known.high.x; ++x)
      edges.isEdge.push_back(isWallEdge(grid, {x, y}));
  return edges;
}

/** Spreads what `better` prefers from each cell to its neighbours, forth and back. It takes the
 *  cell and its index, the index of the neighbour, and whether that lies across a corner. */
template <class Better>
void sweep(const GridFrame& frame, const Better& better) {
  const int w = frame.width, h = frame.height;
  // To a cell from those before it, which are at -1 or at 1 from it along x and y.
  const auto spread = [&](Cell to, int before, bool hasRow) {
    const auto has = [w](int x) { return x >= 0 && x < w; };
    const auto i = std::ptrdiff_t(frame.index(to)), row = i + before * std::ptrdiff_t(w);
    if (hasRow) {
      if (has(to.x + before)) better(to, i, row + before, true);
      better(to, i, row, false);
      if (has(to.x - before)) better(to, i, row - before, true);
    }
    if (has(to.x + before)) better(to, i, i + before, false);
  };
  const auto back = [&](Cell to, int before) {
    const auto i = std::ptrdiff_t(frame.index(to));
    better(to, i, i + before, false);
  };
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) spread({x, y}, -1, y > 0);
    for (int x = w - 1; x-- > 0;) back({x, y}, 1);
  }
  for (int y = h - 1; y >= 0; --y) {
    for (int x = w - 1; x >= 0; --x) spread({x, y}, 1, y + 1 < h);
    for (int x = 1; x < w; ++x) back({x, y}, -1);
  }
}

/** What findNearest() works with: of a large map, new memory for each octant would take a fourth of
 *  its time. */
struct NearestWalls {
  std::vector<std::uint32_t> label;
  std::vector<float> best;
};

/** Fills `nearest.label`. */
void findNearest(const WallMap& map, int octant, NearestWalls& nearest) {
  const GridFrame& frame = map.frame;
  nearest.label.assign(frame.cellCount(), kNoIndex);
  nearest.best.assign(frame.cellCount(), float(WallMap::kReach * WallMap::kReach));
  std::uint32_t* label = nearest.label.data();
  float* best = nearest.best.data();
  const auto offer = [&](Cell c, std::size_t i, std::uint32_t wall) {
    const float d = float(squaredNorm(frame.center(c) - map.walls[wall].place));
    if (d < best[i]) best[i] = d, label[i] = wall;
  };
  const Point axis{std::cos(octant * M_PI_4), std::sin(octant * M_PI_4)};
  for (std::uint32_t i = 0; i < map.walls.size(); ++i) {
    const Cell c = frame.cellAt(map.walls[i].place);
    if (dot(map.walls[i].normal, axis) > M_SQRT1_2) offer(c, frame.index(c), i);
  }
  sweep(frame, [&](Cell to, std::ptrdiff_t i, std::ptrdiff_t from, bool) {
    const std::uint32_t wall = label[from];
    if (wall != kNoIndex && wall != label[i]) offer(to, std::size_t(i), wall);
  });
}

std::vector<float> depthsOf(const GridFrame& frame, const std::vector<State>& states) {
  std::vector<float> depth(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) depth[i] = states[i] == State::free ? 1e6f : 0;
  const float straight = float(frame.resolution), slanted = float(M_SQRT2 * frame.resolution);
  float* cells = depth.data();
  sweep(frame, [&](Cell, std::ptrdiff_t i, std::ptrdiff_t from, bool isSlanted) {
    cells[i] = std::min(cells[i], cells[from] + (isSlanted ? slanted : straight));
  });
  return depth;
}

}  // namespace

Grid coarser(const Grid& grid, double cell, double margin) {
  const CellBox known = knownCells(grid);
  const GridFrame& from = grid.frame;
  Grid out;
  out.frame.resolution = cell;
  if (known.isEmpty()) return out;
  const Point low{from.origin.x + known.low.x * from.resolution,
                  from.origin.y + known.low.y * from.resolution};
  out.frame.origin = low - Point{margin, margin};
  out.frame.width = int(std::ceil((known.width() * from.resolution + 2 * margin) / cell));
  out.frame.height = int(std::ceil((known.height() * from.resolution + 2 * margin) / cell));
  out.cells.resize(out.frame.cellCount(), State::unknown);
  std::vector<std::size_t> column(std::size_t(from.width));
  for (int x = 0; x < from.width; ++x)
    column[std::size_t(x)] = std::size_t(out.frame.cellAt(from.center({x, 0})).x);
  CoarseRow sums(out.frame);
  int row = 0;
  for (int y = known.low.y; y <= known.high.y; ++y) {
    const int next = out.frame.cellAt(from.center({0, y})).y;
    if (next != row) sums.moveTo(out, row);
    row = next;
    for (int x = known.low.x; x <= known.high.x; ++x)
      sums.add(column[std::size_t(x)], grid.at({x, y}));
  }
  sums.moveTo(out, row);
  return out;
}

WallMap bareWallMap(const Grid& grid) {
  const std::optional<Grid> cleared = clearWallRims(grid);
  const Grid& known = cleared ? *cleared : grid;
  const Grid fine = coarser(known, std::max(kWallCell / 2, grid.frame.resolution), WallMap::kReach);
  const Grid coarse = coarser(known, std::max(kWallCell, grid.frame.resolution), WallMap::kReach);
  WallMap map;
  map.frame = coarse.frame;
  map.states = coarse.cells;
  const std::vector<WallPoint> sides = wallSides(fine);
  map.walls = thinned(sides, map.frame);
  map.patches = wallPatches(map.walls);
  map.edges = edgesOf(grid);
  addSearchData(map, sides);
  return map;
}

WallMap wallMap(const Grid& grid) {
  WallMap map = bareWallMap(grid);
  std::vector<double> directions = wallDirections(map.walls);
  map.direction = mainDirection(directions);
  map.axisDeviation = axisDeviation(std::move(directions));
  map.wallSharpness = wallSharpness(grid);
  addLookUp(map);
  map.wallDoubling = wallDoubling(map);
  return map;
}

void addLookUp(WallMap& map) {
  map.depths = {depthsOf(map.frame, map.states), 0};
  NearestWalls nearest;
  for (int k = 0; k < kOctants; ++k) {
    findNearest(map, k, nearest);
    map.nearest[std::size_t(k)] = {nearest.label, kNoIndex};
  }
}

void dropLookUp(WallMap& map) { map.depths = {}, map.nearest = {}; }

void addSearchData(WallMap& map, const std::vector<WallPoint>& walls) {
  map.turns = turnsOf(walls);
  map.freeCells = freeCellsOf(map.frame, map.states);
  const auto free = std::count(map.states.begin(), map.states.end(), State::free);
  map.freeArea = double(free) * map.frame.resolution * map.frame.resolution;
}

}  // namespace roomgraph
