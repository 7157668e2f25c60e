#include "room_rows.h"

#include <algorithm>

#include "page_data.h"
#include "page_values.h"

namespace roomgraph {
namespace {

using kainjow::mustache::data;
using page_values::flag;
using page_values::list;
using page_values::text;

void setSightings(data& row, const SiteRoom& room) {
  std::size_t seen = 0, gone = 0;
  data dots = list();
  for (const RoomInRun& one : room.runs) {
    const bool isSeen = one.sighting == RoomSighting::seen;
    const bool isGone = one.sighting == RoomSighting::gone;
    seen += isSeen, gone += isGone;
    data dot;
    dot.set("kind", nameOf(one.sighting));
    dot.set("title", text(one.run + (isSeen   ? ": seen"
                                     : isGone ? ": looked there, no such room"
                                              : ": has not looked there")));
    dots << dot;
  }
  row.set("seen", std::to_string(seen));
  row.set("of", std::to_string(room.runs.size()));
  row.set("gone", gone ? std::to_string(gone) : std::string());
  row.set("hasGone", flag(gone > 0));
  row.set("isStrip", flag(room.runs.size() <= 16));
  row.set("dots", dots);
}

void setChanges(data& row, const SiteRoom& room) {
  const RoomInRun* far = nullptr;
  int gained = 0, lost = 0, split = 0, merged = 0;
  for (const RoomInRun& one : room.runs) {
    if (one.shift && (!far || *one.shift > *far->shift)) far = &one;
    gained += one.doorsGained > 0, lost += one.doorsLost > 0;
    split += one.pieces > 1, merged += one.isMerged;
  }
  row.set("shift", far ? fixedText(far->shift, 2) : "–");
  row.set("shiftRun", text(far ? far->run : ""));
  std::string changes;
  const auto add = [&](int count, const char* what) {
    if (count == 0) return;
    changes += (changes.empty() ? "" : ", ") + std::string(what) + " in " + std::to_string(count);
  };
  add(split, "split"), add(merged, "merged"), add(gained, "new door"), add(lost, "lost door");
  row.set("changes", changes);
  const bool isSeenByAll =
      std::all_of(room.runs.begin(), room.runs.end(),
                  [](const RoomInRun& one) { return one.sighting == RoomSighting::seen; });
  row.set("isSame", flag(isSeenByAll && changes.empty()));
}

data roomRow(const SiteRoom& room, std::size_t i) {
  data row;
  row.set("index", std::to_string(i));
  row.set("id", text(room.id));
  row.set("name", text(room.name));
  row.set("hasName", flag(room.name != room.id && !room.name.empty()));
  row.set("kind", room.isCorridor ? "corridor" : "room");
  row.set("area", fixedText(room.area, 1));
  setSightings(row, room);
  setChanges(row, room);
  return row;
}

}  // namespace

data roomRows(const std::vector<SiteRoom>& rooms) { return page_values::rowsOf(rooms, roomRow); }

}  // namespace roomgraph
