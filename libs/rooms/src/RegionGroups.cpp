#include "RegionGroups.h"

#include <algorithm>

#include "roomgraph/voronoi/face_areas.h"

namespace roomgraph {
namespace {

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

RegionGroups::RegionGroups(const VoronoiGraph& voronoi, const InsideFlags& isInside,
                           double minClearance, double halfCell)
    : halfCell_(halfCell),
      voronoi_(voronoi),
      isInside_(isInside),
      edges_(edgesByWidth(voronoi, isInside, minClearance)),
      groups_(voronoi.vertices.size()) {
  radius_.reserve(voronoi.vertices.size());
  for (const VoronoiVertex& vertex : voronoi.vertices)
    radius_.push_back(std::max(0.0, vertex.clearance - halfCell));
}

double RegionGroups::elongation(std::uint32_t region) const {
  const double side = 2 * radius_[region];
  return area_[region] / (side * side);
}

void RegionGroups::join(std::uint32_t a, std::uint32_t b) {
  a = find(a);
  b = find(b);
  if (!groups_.join(a, b)) return;
  const std::uint32_t both = find(a);
  radius_[both] = std::max(radius_[a], radius_[b]);
  if (!area_.empty()) area_[both] = area_[a] + area_[b];
}

void RegionGroups::sumAreas() {
  area_ = faceAreas(voronoi_, [&](std::uint32_t v) { return find(v); });
}

void RegionGroups::keepPassages() {
  const auto isInner = [&](std::uint32_t e) {
    return find(voronoi_.edges[e].source) == find(voronoi_.edges[e].target);
  };
  edges_.erase(std::remove_if(edges_.begin(), edges_.end(), isInner), edges_.end());
}

std::map<std::uint32_t, RegionGroups::Neighbours> RegionGroups::neighbours() {
  keepPassages();
  std::map<std::uint32_t, Neighbours> all;
  for (const std::uint32_t e : edges_) {
    const VoronoiEdge& edge = voronoi_.edges[e];
    const std::uint32_t a = find(edge.source), b = find(edge.target);
    for (Passage* passage : {&all[a][b], &all[b][a]}) {
      ++passage->count;
      passage->clearance = std::max(passage->clearance, clearance(edge));
    }
  }
  return all;
}

}  // namespace roomgraph
