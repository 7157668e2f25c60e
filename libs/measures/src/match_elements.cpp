#include "roomgraph/measures/match_elements.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "roomgraph/base/OneToOne.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/geometry/NearPlaces.h"
#include "roomgraph/grid/polygon_cells.h"

namespace roomgraph {
namespace {

/** The room of each cell, and how many cells each room has. */
struct LabelledCells {
  std::vector<RoomId> room;
  std::vector<std::size_t> count;
};

void label(const Polygon& polygon, RoomId room, const GridFrame& frame, LabelledCells& cells) {
  for (const Cell c : cellsIn(polygon, frame)) {
    RoomId& owner = cells.room[frame.index(c)];
    if (owner) continue;  // rooms touch, but do not overlap
    owner = room;
    ++cells.count[room.index()];
  }
}

LabelledCells labelled(const std::vector<GraphRoom>& rooms, const GridFrame& frame) {
  LabelledCells cells{std::vector<RoomId>(frame.cellCount()),
                      std::vector<std::size_t>(rooms.size())};
  for (std::size_t i = 0; i < rooms.size(); ++i)
    label(rooms[i].shape.polygon, RoomId(i), frame, cells);
  return cells;
}

std::vector<MatchedVertices> pairsInReach(const TopologyGraph& base, const TopologyGraph& other,
                                          double maxDistance) {
  const std::vector<Point> places = mapped(other.vertices(), &Vertex::place);
  const NearPlaces near(places, maxDistance);
  std::vector<MatchedVertices> pairs;
  for (std::size_t i = 0; i < base.vertices().size(); ++i) {
    const Point at = base.vertices()[i].place;
    near.forEachNear(at, [&](std::uint32_t j) {
      const double apart = distance(at, places[j]);
      if (apart <= maxDistance) pairs.push_back({VertexId(i), VertexId(j), apart});
    });
  }
  return pairs;
}

std::optional<double> percentile(const std::vector<MatchedVertices>& pairs, double share) {
  if (pairs.empty()) return std::nullopt;
  return quantile(mapped(pairs, &MatchedVertices::distance), share);
}

std::optional<double> unmatched(std::size_t pairs, std::size_t count) {
  if (count == 0) return std::nullopt;
  return double(count - pairs) / double(count);
}

}  // namespace

std::vector<MatchedRooms> matchRooms(const std::vector<GraphRoom>& base,
                                     const std::vector<GraphRoom>& other, const GridFrame& frame) {
  if (base.empty() || other.empty()) return {};
  const LabelledCells a = labelled(base, frame), b = labelled(other, frame);
  std::map<std::pair<RoomId, RoomId>, std::size_t> common;
  for (std::size_t i = 0; i < a.room.size(); ++i)
    if (a.room[i] && b.room[i]) ++common[{a.room[i], b.room[i]}];
  std::vector<MatchedRooms> matched;
  for (const auto& [pair, both] : common) {
    const std::size_t either = a.count[pair.first.index()] + b.count[pair.second.index()] - both;
    const double overlap = double(both) / double(either);
    if (overlap > kMajority) matched.push_back({pair.first, pair.second, overlap});
  }
  return matched;
}

std::vector<MatchedVertices> matchVertices(const TopologyGraph& base, const TopologyGraph& other,
                                           double maxDistance) {
  std::vector<MatchedVertices> pairs = pairsInReach(base, other, maxDistance);
  sortBy(pairs, [](const MatchedVertices& p) { return std::tie(p.distance, p.base, p.other); });
  OneToOne pairing(base.vertices().size(), other.vertices().size());
  std::vector<MatchedVertices> matched;
  for (const MatchedVertices& pair : pairs)
    if (pairing.take(pair.base.index(), pair.other.index())) matched.push_back(pair);
  return matched;
}

VertexAgreement vertexAgreement(const std::vector<MatchedVertices>& pairs, std::size_t baseCount,
                                std::size_t otherCount) {
  return {percentile(pairs, 0.5), percentile(pairs, 0.9), unmatched(pairs.size(), baseCount),
          unmatched(pairs.size(), otherCount)};
}

std::optional<double> nearestVertices(const TopologyGraph& base, const TopologyGraph& other) {
  if (base.vertices().empty() || other.vertices().empty()) return std::nullopt;
  double sum = 0;
  for (const Vertex& vertex : base.vertices()) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vertex& candidate : other.vertices())
      nearest = std::min(nearest, squaredNorm(candidate.place - vertex.place));
    sum += std::sqrt(nearest);
  }
  return sum / double(base.vertices().size());
}

}  // namespace roomgraph
