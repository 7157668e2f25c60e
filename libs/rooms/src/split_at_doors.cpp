#include "roomgraph/rooms/split_at_doors.h"

#include <algorithm>

#include "roomgraph/base/UnionFind.h"

namespace roomgraph {
namespace {

/** The edges inside, from wide to narrow. */
std::vector<std::uint32_t> edgesByWidth(const VoronoiGraph& voronoi, const InsideFlags& isInside,
                                        double minClearance) {
  std::vector<std::uint32_t> edges;
  for (std::uint32_t e = 0; e < voronoi.edges.size(); ++e) {
    const VoronoiEdge& edge = voronoi.edges[e];
    if (!edge.isInfinite() && isInside[edge.source] && isInside[edge.target] &&
        edge.minClearance >= minClearance)
      edges.push_back(e);
  }
  std::stable_sort(edges.begin(), edges.end(), [&](std::uint32_t a, std::uint32_t b) {
    return voronoi.edges[a].minClearance > voronoi.edges[b].minClearance;
  });
  return edges;
}

}  // namespace

void describe(SplitAtDoorsOptions& options, FieldTable& table) {
  const char* section = "split_at_doors";
  table.number(
      section, "max_ratio", options.maxRatio, "", 0, 1,
      "A passage is a door where it is narrower than this share of the narrower of its two "
      "sides.");
  table.number(section, "max_width", options.maxWidth, "m", 0, 100, "A wider passage is no door.");
  table.number(section, "min_room_width", options.minRoomWidth, "m", 0, 100,
               "Where no disc of this diameter fits in is no room of its own.");
  table.number(section, "max_elongation", options.maxElongation, "", 1, 1e6,
               "Area of a room over that of the square round its largest disc; longer ones are "
               "corridors.");
  table.number(section, "max_corridor_width", options.maxCorridorWidth, "m", 0, 1000,
               "A region wider than this is a room, however long it is.");
}

Regions splitAtDoors(const VoronoiGraph& voronoi, const InsideFlags& isInside, double minClearance,
                     const SplitAtDoorsOptions& options) {
  UnionFind groups(voronoi.vertices.size());
  // Of each group, for its first vertex: the radius of its largest disc.
  std::vector<double> widest(voronoi.vertices.size());
  for (std::size_t v = 0; v < widest.size(); ++v) widest[v] = voronoi.vertices[v].clearance;
  for (const std::uint32_t e : edgesByWidth(voronoi, isInside, minClearance)) {
    const VoronoiEdge& edge = voronoi.edges[e];
    const auto a = groups.find(edge.source), b = groups.find(edge.target);
    if (a == b) continue;
    const auto [narrower, wider] = std::minmax(widest[a], widest[b]);
    const bool isDoor = edge.minClearance < options.maxRatio * narrower &&
                        edge.minClearance < options.maxWidth / 2 &&
                        narrower >= options.minRoomWidth / 2;
    if (isDoor) continue;
    const double widestOfBoth = wider;
    groups.join(a, b);
    widest[groups.find(a)] = widestOfBoth;
  }
  return numbered(
      groups, [&](std::uint32_t v) { return isInside[v] != 0; }, widest.size(), 0);
}

bool isCorridor(const Room& region, const SplitAtDoorsOptions& options) {
  return 2 * region.inscribedRadius <= options.maxCorridorWidth &&
         elongation(region) > options.maxElongation;
}

double elongation(const Room& room) {
  const double side = 2 * room.inscribedRadius;
  return area(room.polygon) / (side * side);
}

}  // namespace roomgraph
