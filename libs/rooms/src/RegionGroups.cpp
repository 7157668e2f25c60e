#include "RegionGroups.h"

#include <tuple>

#include "goes_on.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/Polyline.h"
#include "roomgraph/topology/face_areas.h"

namespace roomgraph {
namespace {

std::vector<std::uint32_t> edgesByWidth(const VoronoiGraph& voronoi, const InsideFlags& isInside,
                                        double minClearance) {
  // The widths go along with the numbers: looking them up while sorting costs more than the sort.
  std::vector<std::pair<double, std::uint32_t>> widths;
  for (std::uint32_t e = 0; e < voronoi.edges.size(); ++e) {
    const VoronoiEdge& edge = voronoi.edges[e];
    if (!edge.isInfinite() && isInside[edge.source] && isInside[edge.target] &&
        edge.minClearance >= minClearance)
      widths.push_back({-edge.minClearance, e});
  }
  std::sort(widths.begin(), widths.end());
  std::vector<std::uint32_t> edges;
  edges.reserve(widths.size());
  for (const auto& [width, e] : widths) edges.push_back(e);
  return edges;
}

}  // namespace

RegionGroups::RegionGroups(const VoronoiGraph& voronoi, const InsideFlags& isInside,
                           double minClearance, double halfCell, const SplitAtDoorsOptions& options)
    : halfCell_(halfCell),
      options_(options),
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

std::uint32_t RegionGroups::larger(std::uint32_t a, std::uint32_t b) const {
  const auto rank = [&](std::uint32_t region) {
    return std::tuple(float(area(region)), float(radius(region)), float(wallShare(region)),
                      float(meanWidth(region)));
  };
  return rank(a) < rank(b) ? b : a;
}

bool RegionGroups::isLong(std::uint32_t region) const {
  return elongation(region) > options_.maxElongation &&
         2 * radius(region) <= options_.maxCorridorWidth;
}

bool RegionGroups::isNarrow(std::uint32_t region) const {
  return 2 * radius(region) < options_.openRoomWidth * (1 - kSameWidth);
}

bool RegionGroups::isFacing(const VoronoiEdge& edge) const {
  return distance(voronoi_.obstacles[edge.left], voronoi_.obstacles[edge.right]) >=
         kFacing * 2 * edge.minClearance * (1 - kSameWidth);
}

Point RegionGroups::across(const VoronoiEdge& edge) const {
  const Point across = toLeft(voronoi_.obstacles[edge.right] - voronoi_.obstacles[edge.left]);
  const Point way = voronoi_.vertices[edge.target].place - voronoi_.vertices[edge.source].place;
  return ((dot(across, way) < 0 ? -1 : 1) / norm(across)) * across;
}

bool RegionGroups::isFront(std::uint32_t edge) const {
  return !fronts_.empty() && fronts_[edge] != CubicleEnd::none;
}

void RegionGroups::join(std::uint32_t a, std::uint32_t b) {
  a = find(a);
  b = find(b);
  if (!groups_.join(a, b)) return;
  const std::uint32_t both = find(a);
  radius_[both] = std::max(radius_[a], radius_[b]);
  for (std::vector<double>* sums : {&area_, &bounded_, &walled_, &widened_})
    if (!sums->empty()) (*sums)[both] = (*sums)[a] + (*sums)[b];
}

void RegionGroups::sumAreas() {
  area_ = faceAreas(voronoi_, [&](std::uint32_t v) { return find(v); });
}

void RegionGroups::sumWalls(const std::vector<std::uint8_t>& isWall) {
  bounded_.assign(voronoi_.vertices.size(), 0);
  walled_.assign(voronoi_.vertices.size(), 0);
  widened_.assign(voronoi_.vertices.size(), 0);
  eachStretch([&](const VoronoiEdge& edge, std::uint32_t end, double area) {
    const std::uint32_t region = find(end);
    bounded_[region] += 2 * area;
    widened_[region] += area * (voronoi_.vertices[end].clearance + edge.minClearance);
    walled_[region] += area * ((isWall[edge.left] ? 1 : 0) + (isWall[edge.right] ? 1 : 0));
  });
  double walls = 0, shares = 0;
  for (std::size_t v = 0; v < bounded_.size(); ++v)
    if (bounded_[v] > 0) walls += walled_[v], shares += walled_[v] * walled_[v] / bounded_[v];
  if (walls > 0) meanWallShare_ = shares / walls;
}

void RegionGroups::findOpeningsOffCorridors(const Grid& grid) {
  isOffCorridor_.assign(voronoi_.edges.size(), 0);
  keepPassages();
  for (const std::uint32_t e : edges_)
    isOffCorridor_[e] = isOpeningOffCorridor(voronoi_.edges[e], grid);
}

bool RegionGroups::isOpeningInWall(const VoronoiEdge& edge, const Grid& grid,
                                   WallTest& isIn) const {
  if (clearance(edge) >= options_.corridorDoor / 2 * (1 - kSameWidth)) return false;
  const Point left = voronoi_.obstacles[edge.left], right = voronoi_.obstacles[edge.right];
  return isFacing(edge) && isIn(grid, left, right);
}

bool RegionGroups::isOpeningOffCorridor(const VoronoiEdge& edge, const Grid& grid) const {
  return isOpeningInWall(edge, grid) &&
         isInLongSide(grid, voronoi_.obstacles[edge.left], voronoi_.obstacles[edge.right],
                      options_.maxElongation);
}

double RegionGroups::wallShare(std::uint32_t region) const {
  const double bounded = bounded_[region];
  return bounded > 0 ? walled_[region] / bounded / meanWallShare_ : 0;
}

double RegionGroups::meanWidth(std::uint32_t region) const {
  const double bounded = bounded_[region];
  return bounded > 0 ? 2 * std::max(0.0, widened_[region] / bounded - halfCell_) : 0;
}

Point RegionGroups::narrowest(const VoronoiEdge& edge) const {
  const Point between = midpoint(voronoi_.obstacles[edge.left], voronoi_.obstacles[edge.right]);
  return edge.isInfinite() ? between
                           : nearestOnSegment(between, voronoi_.vertices[edge.source].place,
                                              voronoi_.vertices[edge.target].place);
}

void RegionGroups::keepPassages() {
  const auto isInner = [&](std::uint32_t e) {
    return find(voronoi_.edges[e].source) == find(voronoi_.edges[e].target);
  };
  eraseIf(edges_, isInner);
}

RegionGroups::AllNeighbours RegionGroups::neighbours() {
  keepPassages();
  std::vector<std::tuple<std::uint32_t, std::uint32_t, double, bool, bool, bool>> sides;
  sides.reserve(2 * edges_.size());
  for (const std::uint32_t e : edges_) {
    const VoronoiEdge& edge = voronoi_.edges[e];
    const std::uint32_t a = find(edge.source), b = find(edge.target);
    const bool isOffCorridor = !isOffCorridor_.empty() && isOffCorridor_[e];
    const CubicleEnd cubicle = fronts_.empty() ? CubicleEnd::none : fronts_[e];
    const bool isFront = cubicle != CubicleEnd::none;
    sides.push_back({a, b, clearance(edge), isOffCorridor, isFront, cubicle == CubicleEnd::source});
    sides.push_back({b, a, clearance(edge), isOffCorridor, isFront, cubicle == CubicleEnd::target});
  }
  std::sort(sides.begin(), sides.end());
  AllNeighbours all;
  for (const auto& [a, b, width, isOffCorridor, isFront, isOwnFront] : sides) {
    if (all.empty() || all.back().first != a) all.push_back({a, {}});
    Neighbours& around = all.back().second;
    if (around.empty() || around.back().first != b) around.push_back({b, {}});
    Passage& passage = around.back().second;  // the widest comes last
    passage = {width, passage.clearance, passage.count + 1, isOffCorridor, isFront, isOwnFront};
  }
  return all;
}

bool isDoor(const RegionGroups& regions, double clearance, std::uint32_t a, std::uint32_t b,
            double maxRatio, double maxWidth) {
  const double narrower = std::min(regions.radius(a), regions.radius(b));
  return clearance < std::min(maxRatio * narrower, maxWidth / 2) * (1 - kSameWidth);
}

}  // namespace roomgraph
