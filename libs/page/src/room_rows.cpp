#include "room_rows.h"

#include <algorithm>

#include "page_data.h"

namespace roomgraph {
namespace {

void setSightings(Json& row, const SiteRoom& room) {
  std::size_t seen = 0, gone = 0;
  Json dots = Json::array();
  for (const RoomInRun& one : room.runs) {
    const bool isSeen = one.sighting == RoomSighting::seen;
    const bool isGone = one.sighting == RoomSighting::gone;
    seen += isSeen, gone += isGone;
    dots.push_back({{"kind", nameOf(one.sighting)},
                    {"title", one.run + (isSeen   ? ": seen"
                                         : isGone ? ": looked there, no such room"
                                                  : ": has not looked there")}});
  }
  row["seen"] = std::to_string(seen);
  row["of"] = std::to_string(room.runs.size());
  row["gone"] = gone ? std::to_string(gone) : std::string();
  row["hasGone"] = gone > 0;
  row["isStrip"] = room.runs.size() <= 16;
  row["dots"] = dots;
}

void setChanges(Json& row, const SiteRoom& room) {
  const RoomInRun* far = nullptr;
  int gained = 0, lost = 0, split = 0, merged = 0;
  for (const RoomInRun& one : room.runs) {
    if (one.shift && (!far || *one.shift > *far->shift)) far = &one;
    gained += one.doorsGained > 0, lost += one.doorsLost > 0;
    split += one.pieces > 1, merged += one.isMerged;
  }
  row["shift"] = far ? fixedText(far->shift, 2) : "–";
  row["shiftRun"] = far ? far->run : "";
  std::string changes;
  const auto add = [&](int count, const char* what) {
    if (count == 0) return;
    changes += (changes.empty() ? "" : ", ") + std::string(what) + " in " + std::to_string(count);
  };
  add(split, "split"), add(merged, "merged"), add(gained, "new door"), add(lost, "lost door");
  row["changes"] = changes;
  const bool isSeenByAll =
      std::all_of(room.runs.begin(), room.runs.end(),
                  [](const RoomInRun& one) { return one.sighting == RoomSighting::seen; });
  row["isSame"] = isSeenByAll && changes.empty();
}

Json roomRow(const SiteRoom& room, std::size_t i) {
  Json row{{"index", std::to_string(i)},
           {"id", room.id},
           {"name", room.name},
           {"hasName", room.name != room.id && !room.name.empty()},
           {"kind", room.isCorridor ? "corridor" : "room"},
           {"area", fixedText(room.area, 1)}};
  setSightings(row, room);
  setChanges(row, room);
  return row;
}

}  // namespace

Json roomRows(const std::vector<SiteRoom>& rooms) { return rowsOf(rooms, roomRow); }

}  // namespace roomgraph
