#include "search_images.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {
namespace {

constexpr int kHit = 20, kSidelong = 12;  // a wall that faces the same way; up to 45 degrees off
constexpr int kNear[3] = {10, 7, 5};      // tenths: in the cell, beside it, across its corner
constexpr double kMiddleDepth = 0.7;      // what the middle is: so far from all walls [m]

Cell cellOf(Point p, double cell) {
  return {int(std::floor(p.x / cell)), int(std::floor(p.y / cell))};
}

void setSize(SearchImages& images, const std::vector<SearchPoint>& points) {
  const CellBox box = boundingCells(points);
  images.low = {box.low.x - 1, box.low.y - 1};
  images.width = box.width() + 2;
  images.height = box.height() + 2;
  images.values[0].assign(images.index(0, images.height), 0);
  images.known.assign(std::size_t(images.height), {images.width, 0});
}

void widen(SearchImages::Span& span, int first, int last) {
  span = {std::min(span.first, first), std::max(span.end, last + 1)};
}

/** Nothing new where one with the same cell and octant was added before. */
void addWall(SearchImages& images, const SearchPoint& point) {
  const int column = point.cell.x - images.low.x, row = point.cell.y - images.low.y;
  if (images.values[std::size_t(point.octant)][images.index(column, row)] == kHit) return;
  for (int y = row - 1; y <= row + 1; ++y)
    widen(images.known[std::size_t(y)], column - 1, column + 1);
  for (int turn = -1; turn <= 1; ++turn) {
    auto& values = images.values[std::size_t(point.octant + turn + kOctants) % kOctants];
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const int value = (turn == 0 ? kHit : kSidelong) * kNear[std::abs(dx) + std::abs(dy)] / 10;
        std::int16_t& cell = values[images.index(column + dx, row + dy)];
        cell = cell <= 0 ? std::int16_t(value) : std::max(cell, std::int16_t(value));
      }
  }
}

}  // namespace

CentredMap centred(const WallMap& map) {
  const Point middle = map.middle();
  CentredMap out;
  for (WallPoint wall : map.walls) {
    wall.place = wall.place - middle;
    out.walls.push_back(wall);
  }
  for (const std::uint32_t cell : map.freeCells)
    out.freePlaces.push_back({map.placeOf(cell) - middle, map.depths[cell] >= kMiddleDepth});
  return out;
}

std::vector<SearchPoint> searchPoints(const CentredMap& map, double angle, double cell,
                                      std::size_t maxCount, int sign) {
  const std::size_t stride = (map.walls.size() + maxCount - 1) / maxCount;
  const Motion2D turn(Transform2D{0, 0, angle});
  std::vector<SearchPoint> points;
  points.reserve(map.walls.size() / stride + 1);
  for (std::size_t i = 0; i < map.walls.size(); i += stride) {
    const Cell c = cellOf(turn.turned(map.walls[i].place), cell);
    points.push_back({{sign * c.x, sign * c.y}, octantOf(turn.turned(map.walls[i].normal))});
  }
  return points;
}

CellBox boundingCells(const std::vector<SearchPoint>& points) {
  CellBox box;
  for (const SearchPoint& point : points) box.include(point.cell);
  return box;
}

SearchImages imagesOf(const CentredMap& map, double angle, double cell, int sign) {
  SearchImages images;
  const auto walls = searchPoints(map, angle, cell, map.walls.size(), sign);
  setSize(images, walls);
  const Motion2D turn(Transform2D{0, 0, angle});
  for (const auto& [place, isDeep] : map.freePlaces) {
    const Cell c = cellOf(turn.turned(place), cell);
    const int x = sign * c.x - images.low.x, y = sign * c.y - images.low.y;
    if (x < 0 || y < 0 || x >= images.width || y >= images.height) continue;
    widen(images.known[std::size_t(y)], x, x);
    images.values[0][images.index(x, y)] =
        std::int16_t(isDeep ? -kHit : -kHit / 2);  // a wall in free space
  }
  for (auto& values : images.values) values = images.values[0];
  for (const SearchPoint& wall : walls) addWall(images, wall);
  return images;
}

}  // namespace roomgraph
