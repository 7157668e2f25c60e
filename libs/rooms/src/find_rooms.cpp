#include "roomgraph/rooms/find_rooms.h"

#include <cmath>

#include "number_regions.h"
#include "roomgraph/base/UnionFind.h"
#include "roomgraph/topology/face_areas.h"

namespace roomgraph {

void describe(FindRoomsOptions& options, FieldTable& table) {
  const char* section = "find_rooms";
  table.number(section, "min_width", options.minWidth, "m", 0, 100,
               "Rooms are where a disc of this diameter fits; 0 splits rooms at their doors.");
  table.number(section, "alpha_px2", options.alphaPx2, "px2", 0, 1e8,
               "The same as the paper's alpha, the disc's squared radius in cells; 0 for "
               "min_width.");
}

double roomRadius(const FindRoomsOptions& options, double resolution) {
  return options.alphaPx2 > 0 ? std::sqrt(options.alphaPx2) * resolution : options.minWidth / 2;
}

Regions findRooms(const VoronoiGraph& voronoi, const InsideFlags& isInside, double radius,
                  double minClearance) {
  const auto isWide = [&](std::uint32_t v) { return voronoi.vertices[v].clearance > radius; };
  const auto kindOf = [&](std::uint32_t v) {
    return isWide(v) ? RegionKind::room : RegionKind::corridor;
  };
  UnionFind groups(voronoi.vertices.size());
  for (const VoronoiEdge& edge : voronoi.edges) {
    if (edge.isInfinite() || !isInside[edge.source] || !isInside[edge.target]) continue;
    const bool isInRoom = isWide(edge.source) && isWide(edge.target);
    const bool isInCorridor = !isWide(edge.source) && !isWide(edge.target);
    if ((isInRoom && edge.minClearance > radius) ||
        (isInCorridor && edge.minClearance >= minClearance))
      groups.join(edge.source, edge.target);
  }
  const std::vector<double> areas =
      faceAreas(voronoi, [&](std::uint32_t v) { return groups.find(v); });
  const auto areaOf = [&](std::uint32_t v) { return areas[v]; };
  return numberRegions(voronoi, groups, clearInside(voronoi, isInside, minClearance), kindOf,
                       areaOf, radius);
}

}  // namespace roomgraph
