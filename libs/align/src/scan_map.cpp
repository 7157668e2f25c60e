#include "roomgraph/align/scan_map.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/align/find_scan.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/Polygon.h"

namespace roomgraph {
namespace {

GridFrame frameAround(const std::vector<WallPoint>& walls, const std::vector<Point>& robots,
                      double reach) {
  Box box;
  for (const Point robot : robots) box.include(robot);
  for (const WallPoint& wall : walls) box.include(wall.place);
  const Point size = box.size() + Point{2 * reach, 2 * reach};
  return {int(std::ceil(size.x / kWallCell)), int(std::ceil(size.y / kWallCell)), kWallCell,
          box.low - Point{reach, reach}};
}

/** Marks what a beam has crossed as free. */
void clearBeam(WallMap& map, Point from, Point to) {
  const double length = distance(from, to);
  const int steps = int(length / map.frame.resolution);
  for (int i = 0; i < steps; ++i) {
    const std::size_t cell = cellIndexAt(map.frame, from + (double(i) / steps) * (to - from));
    if (cell < map.states.size() && map.states[cell] == State::unknown)
      map.states[cell] = State::free;
  }
}

/** WallMap::nearest of a map with few walls: each wall is offered to the cells in reach of it,
 *  where addLookUp() goes through all cells. */
void addNearest(WallMap& map, double reach) {
  const int cells = int(reach / map.frame.resolution);
  std::vector<std::uint32_t> nearest(map.frame.cellCount());
  std::vector<float> best(map.frame.cellCount());
  for (int octant = 0; octant < kOctants; ++octant) {
    std::fill(nearest.begin(), nearest.end(), kNoIndex);
    std::fill(best.begin(), best.end(), float(reach * reach));
    const Point axis{std::cos(octant * M_PI_4), std::sin(octant * M_PI_4)};
    for (std::uint32_t w = 0; w < map.walls.size(); ++w) {
      if (dot(map.walls[w].normal, axis) <= M_SQRT1_2) continue;
      const Point place = map.walls[w].place;
      const Cell there = map.frame.cellAt(place);
      for (int y = there.y - cells; y <= there.y + cells; ++y)
        for (int x = there.x - cells; x <= there.x + cells; ++x) {
          const std::size_t cell = map.frame.index({x, y});
          const auto off = float(squaredNorm(map.frame.center({x, y}) - place));
          if (off < best[cell]) best[cell] = off, nearest[cell] = w;
        }
    }
    map.nearest[std::size_t(octant)] = {nearest, kNoIndex};
  }
}

}  // namespace

WallMap scanMap(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& poses,
                const std::vector<std::size_t>& chosen, double range) {
  WallMap map;
  std::vector<Point> robots;
  std::vector<std::size_t> ends;  // of the walls of each scan
  for (const std::size_t k : chosen) {
    const Motion2D forth(poses[k]);
    for (const WallPoint& wall : scans[k].walls)
      if (squaredNorm(wall.place) < range * range)
        map.walls.push_back({forth(wall.place), forth.turned(wall.normal)});
    robots.push_back(poses[k].shift());
    ends.push_back(map.walls.size());
  }
  if (map.walls.empty()) return map;
  const double reach = kScanBand.first + kWallCell;  // walls farther away are not looked for
  map.frame = frameAround(map.walls, robots, reach);
  map.states.assign(map.frame.cellCount(), State::unknown);
  for (const WallPoint& wall : map.walls)
    map.states[cellIndexAt(map.frame, wall.place)] = State::occupied;
  std::size_t w = 0;
  for (std::size_t i = 0; i < robots.size(); ++i)
    for (; w < ends[i]; ++w) {
      const Point here = map.walls[w].place;
      clearBeam(map, robots[i], here);
      if (w + 1 == ends[i]) continue;
      const Point next = map.walls[w + 1].place;
      const double gap = distance(here, next);
      if (gap > 2 * kSameSurface) continue;
      for (int step = 1; step * kWallCell < gap; ++step)
        clearBeam(map, robots[i], here + (step * kWallCell / gap) * (next - here));
    }
  addNearest(map, reach);
  return map;
}

WallMap stretchMap(const std::vector<ScanWalls>& scans, std::size_t first, std::size_t end) {
  const std::vector<ScanWalls> some(scans.begin() + std::ptrdiff_t(first),
                                    scans.begin() + std::ptrdiff_t(end));
  WallMap map = scanMap(localScans(some), drawnPoses(some), numbersFrom(0, some.size()), HUGE_VAL);
  if (map.walls.empty()) return map;
  addSearchData(map, map.walls);
  addLookUp(map);
  return map;
}

}  // namespace roomgraph
