#include "find_fronts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "goes_on.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

/** Of the width of a front: how much wall stands beside each of its ends, in the mean, and how far
 *  nothing stands before that wall. */
constexpr double kBesideFront = 0.125;

/** An end of an opening, with directions that are one cell long. */
struct End {
  Point place, away, inward;
};

/** Seen from before it; `cells` is its width. */
struct Opening {
  End from, to;
  int cells;
};

Opening makeOpening(const Grid& grid, Point from, Point to, Point inward) {
  const Point along = (grid.frame.resolution / distance(from, to)) * (to - from);
  return {{from, -1 * along, inward},
          {to, along, inward},
          int(distance(from, to) / grid.frame.resolution * (1 + kSameWidth))};
}

/** Wall in line with an opening, beside one of its ends. */
struct Beside {
  int cells;
  bool endsThere;  // else the wall that goes off inward comes from before the opening
};

/** How much wall stands there, with nothing before it, until a wall goes off inward; half of the
 *  opening where none does, but all is wall. */
std::optional<Beside> wallBeside(const Grid& grid, const End& end, Point other, int half) {
  const double depth = std::ceil(2 * half * kBesideFront);
  for (int i = 0; i <= half; ++i) {
    const Point place = end.place + double(i) * end.away, before = place - depth * end.inward;
    if (i > 0 && grid.isFree(place)) return std::nullopt;
    const bool isOpen = grid.isFree(before);
    if (!isOpen && i < depth) return std::nullopt;
    if (isNowhereFree(grid, place, end.inward, half)) {
      // A straight wall beside the opening is no corner, even where the opening meets it askew.
      const bool isCorner = i > 0 || freeRun(grid, before, end.away) >= depth / 2;
      return isCorner ? std::optional(Beside{i, isOpen}) : std::nullopt;
    }
    if (!isOpen) return std::nullopt;
  }
  return isMostlyWall(grid, end.place, other) ? std::optional(Beside{half, true}) : std::nullopt;
}

/** From an opening to the inner side of the wall beside it, by the thinner of its ends: where a
 *  partition goes off, that is as long. */
Point throughWall(const Grid& grid, const Opening& opening) {
  const auto isWall = [&](const End& end, int cells) {
    return !grid.isFree(end.place + end.away + (cells + 1.0) * end.inward);
  };
  int cells = 0;
  while (cells < opening.cells / 2 && isWall(opening.from, cells) && isWall(opening.to, cells))
    ++cells;
  return double(cells) * opening.to.inward;
}

/** How long it is along an opening behind it, at most so deep, where it is shortest [cells]. */
double leastLength(const Grid& grid, const Opening& opening, int deepest) {
  const auto& [from, to, width] = opening;
  const Point start = midpoint(from.place, to.place) + throughWall(grid, opening);
  const double depth = std::min<double>(deepest, freeRun(grid, start, to.inward));
  double least = std::numeric_limits<double>::max();
  for (const double share : {0.25, 0.5, 0.75}) {
    const Point inside = start + share * depth * to.inward;
    least = std::min(least, 1 + freeRun(grid, inside, to.away) + freeRun(grid, inside, from.away));
  }
  return least;
}

/** Whether a cubicle lies behind an opening, judged by so much of its depth. */
bool hasCubicle(const Grid& grid, const Opening& opening, int deepest) {
  const auto& [from, to, width] = opening;
  const std::optional<Beside> first = wallBeside(grid, from, to.place, width / 2);
  if (!first) return false;
  const std::optional<Beside> last = wallBeside(grid, to, from.place, width / 2);
  if (!last || !(first->endsThere || last->endsThere)) return false;
  const int free = width - 1;
  const double least = 2 * kBesideFront * free;
  return first->cells + last->cells >= least && leastLength(grid, opening, deepest) - free >= least;
}

/** Whether a cubicle lies behind an opening, and none before it: halves of a room are none, nor are
 *  the spaces between the shelves of a hall. */
bool isFront(const Grid& grid, Point from, Point to, Point inward) {
  constexpr int kAll = std::numeric_limits<int>::max();
  const Opening opening = makeOpening(grid, from, to, inward);
  if (!hasCubicle(grid, opening, kAll)) return false;
  const Point through = throughWall(grid, opening), outward = -1 * inward;
  const Opening back = makeOpening(grid, from, to, outward);
  const Opening innerBack = makeOpening(grid, from + through, to + through, outward);
  return !hasCubicle(grid, back, kAll) && !hasCubicle(grid, back, back.cells / 2) &&
         !hasCubicle(grid, innerBack, back.cells / 2);
}

/** An edge that leads through a front, with the ends of that. */
struct Front {
  std::uint32_t edge;
  CubicleEnd side;
  Point from, to;
  double width;
};

bool areNear(const Front& a, const Front& b) {
  const double near = kBesideFront * a.width;
  return (distance(a.from, b.from) <= near && distance(a.to, b.to) <= near) ||
         (distance(a.from, b.to) <= near && distance(a.to, b.from) <= near);
}

CubicleEnd cubicleEnd(const RegionGroups& regions, const VoronoiEdge& edge, const Grid& grid) {
  const VoronoiGraph& voronoi = regions.voronoi();
  const Point from = voronoi.obstacles[edge.left], to = voronoi.obstacles[edge.right];
  const Point onward = grid.frame.resolution * regions.across(edge);
  return isFront(grid, from, to, onward)        ? CubicleEnd::target
         : isFront(grid, from, to, -1 * onward) ? CubicleEnd::source
                                                : CubicleEnd::none;
}

/** From wide to narrow. */
std::vector<Front> allFronts(const RegionGroups& regions, const Grid& grid) {
  const VoronoiGraph& voronoi = regions.voronoi();
  std::vector<Front> fronts;
  for (const std::uint32_t e : regions.edges()) {
    const VoronoiEdge& edge = voronoi.edges[e];
    if (2 * regions.clearance(edge) < regions.options().corridorDoor) break;
    if (!regions.isFacing(edge)) continue;
    const Point from = voronoi.obstacles[edge.left], to = voronoi.obstacles[edge.right];
    const CubicleEnd side = cubicleEnd(regions, edge, grid);
    if (side != CubicleEnd::none) fronts.push_back({e, side, from, to, distance(from, to)});
  }
  return fronts;
}

}  // namespace

std::vector<CubicleEnd> findFronts(const RegionGroups& regions, const Grid& grid) {
  const std::vector<Front> fronts = allFronts(regions, grid);
  std::vector<CubicleEnd> sides(regions.voronoi().edges.size(), CubicleEnd::none);
  for (const Front& front : fronts) {
    const auto isNarrower = [&](const Front& other) {
      return other.width < front.width * (1 - kSameWidth) && areNear(front, other);
    };
    if (!anyOf(fronts, isNarrower)) sides[front.edge] = front.side;
  }
  return sides;
}

}  // namespace roomgraph
