#include "roomgraph/repair/places_site.h"

#include "json_things.h"
#include "roomgraph/base/read_document.h"

namespace roomgraph {
namespace {

std::vector<Json*> roomsIn(Json& document) {
  if (!document.contains("rooms") || !document["rooms"].is_array())
    throw Broken{"", "has no list of rooms"};
  std::vector<Json*> rooms;
  for (Json& room : document["rooms"]) rooms.push_back(&room);
  return rooms;
}

std::string nameOfRoom(const Json& room) {
  return room.is_object() && room.contains("id") && room["id"].is_string()
             ? room["id"].get<std::string>()
             : "";
}

void visitRoom(Json& room, const VisitPlace& visit) {
  visitXY(room, visit);
  for (const char* outline : {"polygon", "holes"})
    if (room.contains(outline)) visitPositions(room[outline], true, visit);
  if (room.contains("doors"))
    for (Json& door : room["doors"]) visitXY(door, visit);
}

}  // namespace

bool looksLikeSite(const std::string& text) {
  return text.find("\"roomgraph/site\"") != std::string::npos;
}

MarkedFile sitePlaces(const std::string& text, const std::string& file) {
  return markedJson(text, file, {"room", roomsIn, nameOfRoom, visitRoom, [](Json& room) -> Json& {
                                   return room;
                                 }});
}

}  // namespace roomgraph
