#include "own_widths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace roomgraph {
namespace {

/** Two obstacles face each other where they are nearly as far apart as the disc between them is
 *  wide: the cosine of a quarter of a right angle. */
constexpr double kFacing = 0.924;

/** Closer ones lie on one side of it: there is a branch of the diagram into each dent of a wall. */
constexpr double kOneSide = 0.5;

/** What lies beside a part of a way between two walls that face each other. */
struct Stretch {
  double width, area;
};

/** All of one region. */
struct Stretches {
  std::vector<Stretch> facing;
  double facingArea = 0, area = 0;
};

/** The mean width of the largest part of a region's stretches that is about as wide everywhere;
 *  infinity if that is less than half of its area. */
double mainWidth(Stretches& of) {
  double largest = of.area / 2, width = std::numeric_limits<double>::infinity();
  if (of.facingArea <= largest) return width;
  std::sort(of.facing.begin(), of.facing.end(), [](const Stretch& p, const Stretch& q) {
    return std::tie(p.width, p.area) < std::tie(q.width, q.area);
  });
  double area = 0, sum = 0;  // from low to high
  for (auto low = of.facing.begin(), high = low; high != of.facing.end(); ++high) {
    area += high->area, sum += high->area * high->width;
    for (; low->width * std::sqrt(2.0) < high->width; ++low)
      area -= low->area, sum -= low->area * low->width;
    if (area > largest) largest = area, width = sum / area;
  }
  return width;
}

}  // namespace

std::vector<double> ownWidths(RegionGroups& regions, const std::vector<std::uint8_t>& isWall) {
  const VoronoiGraph& voronoi = regions.voronoi();
  std::vector<Stretches> stretches(voronoi.vertices.size());
  regions.eachStretch([&](const VoronoiEdge& edge, std::uint32_t end, double area) {
    const double width = voronoi.vertices[end].clearance + edge.minClearance;
    const double apart = norm(voronoi.obstacles[edge.right] - voronoi.obstacles[edge.left]);
    if (apart < kOneSide * width) return;
    Stretches& of = stretches[regions.find(end)];
    of.area += area;
    if (apart < kFacing * width || !isWall[edge.left] || !isWall[edge.right]) return;
    of.facing.push_back({std::max(0.0, width - 2 * regions.halfCell()), area});
    of.facingArea += area;
  });
  std::vector<double> widths(voronoi.vertices.size());
  for (std::uint32_t v = 0; v < widths.size(); ++v)
    widths[v] = std::min(2 * regions.radius(v), mainWidth(stretches[v]));
  return widths;
}

}  // namespace roomgraph
