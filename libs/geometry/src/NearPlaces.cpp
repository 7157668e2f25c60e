#include "roomgraph/geometry/NearPlaces.h"

namespace roomgraph {

NearPlaces::NearPlaces(const std::vector<Point>& places, double reach) : reach_(reach) {
  entries_.reserve(places.size());
  for (const Point place : places)
    entries_.push_back({squareOf(place), std::uint32_t(entries_.size())});
  std::sort(entries_.begin(), entries_.end());
}

}  // namespace roomgraph
