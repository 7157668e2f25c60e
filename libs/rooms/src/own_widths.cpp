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
  std::uint32_t region;
  double width, area;
};

/** Of stretches of one region, from narrow to wide: the mean width of the largest part of them that
 *  is about as wide everywhere; infinity if that is less than half of its area. */
double mainWidth(const Stretch* first, const Stretch* last, double areaOfRegion) {
  double area = 0, sum = 0;  // from low to high
  double largest = areaOfRegion / 2, width = std::numeric_limits<double>::infinity();
  for (const Stretch *low = first, *high = first; high < last; ++high) {
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
  std::vector<double> areas(voronoi.vertices.size()), widths(voronoi.vertices.size());
  std::vector<Stretch> stretches;
  regions.eachStretch([&](const VoronoiEdge& edge, std::uint32_t end, double area) {
    const double width = voronoi.vertices[end].clearance + edge.minClearance;
    const double apart = norm(voronoi.obstacles[edge.right] - voronoi.obstacles[edge.left]);
    if (apart < kOneSide * width) return;
    const std::uint32_t region = regions.find(end);
    areas[region] += area;
    if (apart >= kFacing * width && isWall[edge.left] && isWall[edge.right])
      stretches.push_back({region, std::max(0.0, width - 2 * regions.halfCell()), area});
  });
  std::sort(stretches.begin(), stretches.end(), [](const Stretch& p, const Stretch& q) {
    return std::tie(p.region, p.width, p.area) < std::tie(q.region, q.width, q.area);
  });
  for (std::uint32_t v = 0; v < widths.size(); ++v) widths[v] = 2 * regions.radius(v);
  for (std::size_t i = 0, end = 0; i < stretches.size(); i = end) {
    const std::uint32_t region = stretches[i].region;
    while (end < stretches.size() && stretches[end].region == region) ++end;
    const double width = mainWidth(&stretches[i], stretches.data() + end, areas[region]);
    widths[region] = std::min(widths[region], width);
  }
  return widths;
}

}  // namespace roomgraph
