#include "roomgraph/measures/match_rooms.h"

#include <map>
#include <utility>

#include "roomgraph/base/majority.h"
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

}  // namespace roomgraph
