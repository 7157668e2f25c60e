#include "roomgraph/ledger/name_areas.h"

#include <algorithm>
#include <map>

#include "roomgraph/base/Error.h"
#include "roomgraph/ledger/name_rooms.h"

namespace roomgraph {
namespace {

/** Any id will do: the areas get new ones. */
std::string idOf(AreaId area) { return std::to_string(area.index()); }

std::vector<SiteRoom> roomsOf(const AreaGraph& graph) {
  std::vector<SiteRoom> rooms;
  for (std::size_t a = 0; a < graph.areas.size(); ++a) {
    const Area& area = graph.areas[a];
    SiteRoom& room = rooms.emplace_back();
    room.id = idOf(AreaId(a)), room.isCorridor = !area.isRoom();
    room.center = area.widestPlace, room.polygon = area.polygon;
    room.area = roomgraph::area(area.polygon);
    for (const PassageId p : area.passages) {
      const Passage& passage = graph.passages[p.index()];
      const AreaId to = passage.a == AreaId(a) ? passage.b : passage.a;
      room.doors.push_back({passage.middle(), passage.width, idOf(to)});
    }
    room.runs.emplace_back().run = room.id;
  }
  return rooms;
}

}  // namespace

NamedAreas nameAreas(const AreaGraph& areas, SiteFile file, const std::string& name) {
  NamedRooms named = nameRooms(roomsOf(areas), std::move(file), name);
  std::map<std::string, int> uses;
  for (const SiteRoom& room : named.rooms) ++uses[room.name];
  NamedAreas result{std::vector<std::string>(areas.areas.size()), std::move(named.file)};
  for (const SiteRoom& room : named.rooms)  // what a room was before, its only run tells
    result.names[std::stoul(room.runs.front().run)] =
        uses[room.name] > 1 && room.name != room.id ? room.name + " (" + room.id + ")" : room.name;
  return result;
}

}  // namespace roomgraph
