#include "seen_places.h"

#include <algorithm>
#include <cmath>

namespace roomgraph {
namespace {

std::int64_t squareAt(double metres) {
  constexpr double most = 1 << 30;  // so that both coordinates fit into one number
  return std::int64_t(std::floor(std::clamp(metres, -most, most)));
}

}  // namespace

SeenPlaces seenPlaces(const WallMap& map, const Transform2D& pose) {
  SeenPlaces places;
  for (const std::uint32_t cell : map.freeCells) {
    const Point place = pose(map.placeOf(cell));
    places.push_back(squareAt(place.x) * (std::int64_t(1) << 32) + squareAt(place.y));
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

}  // namespace roomgraph
