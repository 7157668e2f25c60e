#include "roomgraph/report/site_json.h"

#include <set>

#include "roomgraph/base/read_document.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/point_json.h"
#include "roomgraph/report/json_parts.h"

namespace roomgraph {
namespace {

/** GeoJSON repeats the first point of a ring at its end. */
Ring closed(Ring ring) {
  if (!ring.empty()) ring.push_back(ring.front());
  return ring;
}

Json polygonJson(const Polygon& polygon) {
  Json rings = Json::array({ringJson(closed(polygon.outer))});
  for (const Ring& hole : polygon.holes) rings.push_back(ringJson(closed(hole)));
  return rings;
}

Json runsWith(const SiteRoom& room, RoomSighting sighting) {
  Json names = Json::array();
  for (const RoomInRun& in : room.runs)
    if (in.sighting == sighting) names.push_back(in.run);
  return names;
}

Json feature(const Json& properties, const char* type, const Json& coordinates) {
  return {{"type", "Feature"},
          {"properties", properties},
          {"geometry", {{"type", type}, {"coordinates", coordinates}}}};
}

Json roomFeature(const SiteRoom& room) {
  const Json properties = {{"id", room.id},
                           {"name", room.name},
                           {"kind", room.isCorridor ? "corridor" : "room"},
                           {"area_m2", rounded(room.area)},
                           {"seen_in", runsWith(room, RoomSighting::seen)},
                           {"gone_in", runsWith(room, RoomSighting::gone)},
                           {"unvisited_in", runsWith(room, RoomSighting::unvisited)}};
  return feature(properties, "Polygon", polygonJson(room.polygon));
}

Json doorFeature(const SiteRoom& room, const SiteDoor& door) {
  const Json properties = {{"kind", "door"},
                           {"room", room.id},
                           {"to", door.to.empty() ? Json() : Json(door.to)},
                           {"width", rounded(door.width)},
                           {"seen_in", door.seenIn},
                           {"lost_in", door.lostIn}};
  return feature(properties, "Point", {rounded(door.place.x), rounded(door.place.y)});
}

Ring ring(const JsonNode& node) {
  Ring result = readPoints(node);
  if (result.size() < 3) throw Broken{node.place, "has fewer than 3 corners"};
  return result;
}

int nextNumber(const JsonNode& node) {
  constexpr std::size_t kMost = 1'000'000'000;
  const std::size_t number = node.countBelow(kMost);
  if (number == 0) throw Broken{node.place, "is not a number from 1 on"};
  return int(number);
}

SiteDoor door(const JsonNode& node) {
  const JsonNode to = node["to"];
  return {readPlace(node), readCoordinate(node["width"]), to.json.is_null() ? "" : to.text()};
}

SiteRoom room(const JsonNode& node) {
  SiteRoom result;
  result.id = node["id"].text();
  if (result.id.empty()) throw Broken{node["id"].place, "is empty"};
  result.name = node.contains("name") ? node["name"].text() : "";
  if (result.name.empty()) result.name = result.id;
  const std::string kind = node["kind"].text();
  if (kind != "room" && kind != "corridor")
    throw Broken{node["kind"].place, "is neither 'room' nor 'corridor'"};
  result.isCorridor = kind == "corridor";
  result.center = readPlace(node);
  result.area = readCoordinate(node["area_m2"]);
  result.polygon.outer = ring(node["polygon"]);
  for (const JsonNode& hole : node["holes"].list()) result.polygon.holes.push_back(ring(hole));
  for (const JsonNode& one : node["doors"].list()) result.doors.push_back(door(one));
  return result;
}

SiteFile site(const JsonNode& top) {
  if (top["version"].json != 1)
    throw Broken{"version", "is not 1, the only one that this program reads"};
  SiteFile file;
  file.nextRoom = nextNumber(top["next"]["room"]);
  file.nextCorridor = nextNumber(top["next"]["corridor"]);
  std::set<std::string> ids;
  for (const JsonNode& node : top["rooms"].list()) {
    file.rooms.push_back(room(node));
    if (!ids.insert(file.rooms.back().id).second)
      throw Broken{node["id"].place, "is that of another room, too"};
  }
  return file;
}

}  // namespace

std::string siteGeojson(const Comparison& comparison) {
  std::string features;
  const auto add = [&](const Json& json) {
    features += (features.empty() ? "\n" : ",\n") + lineOf(json);
  };
  for (const SiteRoom& room : comparison.rooms) {
    add(roomFeature(room));
    for (const SiteDoor& door : room.doors) add(doorFeature(room, door));
  }
  return "{\n\"type\": \"FeatureCollection\",\n\"name\": \"roomgraph site\",\n\"crs\": {\"type\": "
         "\"name\", \"properties\": {\"name\": \"urn:ogc:def:crs:EPSG::3857\"}},\n\"features\": [" +
         features + "\n]\n}\n";
}

SiteFile parseSiteJson(const std::string& content, const std::string& name) {
  return readDocument(content, name, "roomgraph/site",
                      "repair it, or name another file with --names", site);
}

std::string siteJson(const SiteFile& file) {
  JsonDocument document("roomgraph/site");
  document.add("next", {{"room", file.nextRoom}, {"corridor", file.nextCorridor}});
  document.addList("rooms", file.rooms, [](const SiteRoom& room) {
    return placedRoomJson(room, mapped(room.doors, doorJson));
  });
  return std::move(document).text();
}

}  // namespace roomgraph
