#include "roomgraph/report/site_geojson.h"

#include "json_places.h"

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

}  // namespace roomgraph
