#include "roomgraph/rooms/find_rooms.h"

#include <cmath>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/rooms/trace_rooms.h"

namespace roomgraph {
namespace {

Regions wideRegions(const VoronoiGraph& voronoi, const InsideFlags& isInside, double radius) {
  const auto isWide = [&](std::uint32_t v) {
    return isInside[v] && voronoi.vertices[v].clearance > radius;
  };
  UnionFind groups(voronoi.vertices.size());
  for (const VoronoiEdge& edge : voronoi.edges)
    if (edge.minClearance > radius && !edge.isInfinite() && isWide(edge.source) &&
        isWide(edge.target))
      groups.join(edge.source, edge.target);
  return numbered(groups, isWide, voronoi.vertices.size(), radius);
}

}  // namespace

void describe(FindRoomsOptions& options, FieldTable& table) {
  const char* section = "find_rooms";
  table.number(section, "min_width", options.minWidth, "m", 0, 100,
               "A room is where a disc of this diameter fits in everywhere; 0 to split at doors.");
  table.number(section, "alpha_px2", options.alphaPx2, "px2", 0, 1e8,
               "The same as the paper's alpha, the disc's squared radius in cells; 0 for "
               "min_width.");
}

double roomRadius(const FindRoomsOptions& options, double resolution) {
  return options.alphaPx2 > 0 ? std::sqrt(options.alphaPx2) * resolution : options.minWidth / 2;
}

Rooms findRooms(const VoronoiGraph& voronoi, const InsideFlags& isInside, double radius) {
  return traceRooms(voronoi, wideRegions(voronoi, isInside, radius));
}

}  // namespace roomgraph
