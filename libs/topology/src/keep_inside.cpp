#include "roomgraph/topology/keep_inside.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/topology/face_areas.h"

namespace roomgraph {
namespace {

/** Clears the flags of what a disc of `radius` reaches from infinity. */
void removeOutside(const VoronoiGraph& graph, double radius, InsideFlags& isInside) {
  const auto infinity = std::uint32_t(graph.vertices.size());
  UnionFind regions(graph.vertices.size() + 1);
  for (const VoronoiEdge& edge : graph.edges)
    if (edge.minClearance > radius)
      regions.join(edge.source, edge.isInfinite() ? infinity : edge.target);
  const std::uint32_t outside = regions.find(infinity);
  for (std::uint32_t v = 0; v < infinity; ++v)
    if (regions.find(v) == outside) isInside[v] = 0;
}

void removeNotFree(const VoronoiGraph& graph, const Grid& grid, InsideFlags& isInside) {
  for (std::size_t v = 0; v < graph.vertices.size(); ++v)
    if (isInside[v] && !grid.isFree(graph.vertices[v].place)) isInside[v] = 0;
}

/** Keeps the connected set of Delaunay faces with the largest area. */
void keepBiggest(const VoronoiGraph& graph, InsideFlags& isInside) {
  UnionFind polygons(graph.vertices.size());
  const auto isInner = [&](std::uint32_t v) { return v != VoronoiEdge::kNoVertex && isInside[v]; };
  for (const VoronoiEdge& edge : graph.edges)
    if (isInner(edge.source) && isInner(edge.target)) polygons.join(edge.source, edge.target);
  const std::vector<double> area = faceAreas(graph, [&](std::uint32_t v) {
    return isInside[v] ? polygons.find(v) : VoronoiEdge::kNoVertex;
  });
  if (area.empty()) return;
  const auto biggest = std::uint32_t(std::max_element(area.begin(), area.end()) - area.begin());
  for (std::uint32_t v = 0; v < isInside.size(); ++v)
    if (isInside[v] && polygons.find(v) != biggest) isInside[v] = 0;
}

}  // namespace

void describe(KeepInsideOptions& options, FieldTable& table) {
  const char* section = "keep_inside";
  table.number(section, "outside_width", options.outsideWidth, "m", 0.5, 1000,
               "Outside is what a disc of this diameter reaches from beyond all obstacles; never "
               "below 1.5 cells.");
  table.number(section, "outside_alpha_px2", options.outsideAlphaPx2, "px2", 0, 1e9,
               "The same as alpha, the disc's squared radius in cells; 0 for outside_width.");
  table.flag(section, "biggest_only", options.biggestOnly,
             "Keep the biggest outer polygon only, as the paper does.");
  table.flag(section, "free_only", options.freeOnly, "Keep only what lies in free cells.");
}

InsideFlags keepInside(const VoronoiGraph& graph, const Grid& grid,
                       const KeepInsideOptions& options) {
  InsideFlags isInside(graph.vertices.size(), 1);
  // Between the cells of a slanted wall a smaller disc would pass.
  const double throughWalls = 0.75 * grid.frame.resolution;
  const double radius = options.outsideAlphaPx2 > 0
                            ? std::sqrt(options.outsideAlphaPx2) * grid.frame.resolution
                            : std::max(options.outsideWidth / 2, throughWalls);
  removeOutside(graph, radius, isInside);
  if (options.freeOnly) removeNotFree(graph, grid, isInside);
  if (options.biggestOnly) keepBiggest(graph, isInside);
  return isInside;
}

}  // namespace roomgraph
