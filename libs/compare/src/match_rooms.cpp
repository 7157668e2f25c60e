#include "roomgraph/compare/match_rooms.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace roomgraph {
namespace {

constexpr double kSameRoom = 0.5;

/** The room of each cell, and how many cells each room has. */
struct LabelledCells {
  std::vector<RoomId> room;
  std::vector<std::size_t> count;
};

/** Where row `y` of the cell centres enters and leaves the polygon. */
std::vector<double> crossings(const Polygon& polygon, double y) {
  std::vector<double> xs;
  const auto addRing = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
      if ((a.y <= y) != (b.y <= y)) xs.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
  };
  addRing(polygon.outer);
  for (const Ring& hole : polygon.holes) addRing(hole);
  std::sort(xs.begin(), xs.end());
  return xs;
}

void label(const Polygon& polygon, RoomId room, const GridFrame& frame, LabelledCells& cells) {
  if (polygon.outer.empty()) return;
  const Box box = boundingBox(polygon.outer);
  const int low = std::max(0, frame.cellAt(box.low).y);
  const int high = std::min(frame.height - 1, frame.cellAt(box.high).y);
  const auto column = [&](double x) {  // the first whose centre is not left of x
    const double c = std::ceil((x - frame.origin.x) / frame.resolution - 0.5);
    return int(std::clamp(c, 0.0, double(frame.width)));
  };
  for (int y = low; y <= high; ++y) {
    const std::vector<double> xs = crossings(polygon, frame.center({0, y}).y);
    for (std::size_t k = 0; k + 1 < xs.size(); k += 2)
      for (int x = column(xs[k]); x < column(xs[k + 1]); ++x) {
        RoomId& owner = cells.room[frame.index({x, y})];
        if (owner) continue;  // rooms touch, but do not overlap
        owner = room;
        ++cells.count[room.index()];
      }
  }
}

LabelledCells labelled(const std::vector<GraphRoom>& rooms, const GridFrame& frame) {
  LabelledCells cells{std::vector<RoomId>(frame.cellCount()),
                      std::vector<std::size_t>(rooms.size())};
  for (std::size_t i = 0; i < rooms.size(); ++i)
    label(rooms[i].shape.polygon, RoomId(i), frame, cells);
  return cells;
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
    if (overlap > kSameRoom) matched.push_back({pair.first, pair.second, overlap});
  }
  return matched;
}

}  // namespace roomgraph
