#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "roomgraph/base/Json.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/read_document.h"
#include "roomgraph/repair/places_formats.h"

namespace roomgraph {
namespace {

/** Told x and y of each place of a thing, in their order, and whether it is a corner of an area. */
using VisitPlace = std::function<void(Json& x, Json& y, bool isCorner)>;

/** How things stand in a JSON document. */
struct JsonThings {
  const char* kind;  ///< as in MarkedFile
  /** All of the document. @throws Broken where it is another one. */
  std::vector<Json*> (*in)(Json& document);
  std::string (*nameOf)(const Json& thing);
  /** @throws Broken where something is no place. */
  void (*visitPlaces)(Json& thing, const VisitPlace& visit);
  Json& (*membersOf)(Json& thing);  ///< where its state is written
};

/** The number of a place among those of the file, where it is there once. */
class PlaceIndex {
 public:
  explicit PlaceIndex(std::vector<Place>& places) : places_(places) {}

  std::size_t operator()(Point place, bool isCorner) {
    const auto [known, isNew] = known_.emplace(std::make_pair(place, isCorner), places_.size());
    if (isNew) places_.push_back({"", {place.x, place.y, 0}, isCorner});
    return known->second;
  }

 private:
  std::vector<Place>& places_;
  std::map<std::pair<Point, bool>, std::size_t> known_;
};

double metres(const Json& value) {
  if (!value.is_number() || !(std::abs(value.get<double>()) < kFarthestOrigin))
    throw Broken{"", "has coordinates that are no place on a map"};
  return value.get<double>();
}

/** One member per line, and one entry per line of a list of objects. */
std::string textOf(const Json& document) {
  std::string text = "{";
  const char* next = "\n";
  for (const auto& [name, value] : document.items()) {
    text += next + Json(name).dump() + ": ";
    next = ",\n";
    if (!value.is_array() || value.empty() || !value[0].is_object()) {
      text += lineOf(value);
      continue;
    }
    const char* separator = "[\n";
    for (const Json& entry : value) text += separator + lineOf(entry), separator = ",\n";
    text += "\n]";
  }
  return text + "\n}\n";
}

void setState(Json& members, const CarriedThing& carried) {
  if (!members.is_object()) members = Json::object();
  members["state"] = nameOf(carried.state);
  members.erase("error_m"), members.erase("reason");
  if (carried.error) members["error_m"] = rounded(*carried.error);
  if (!carried.reason.empty()) members["reason"] = carried.reason;
}

std::string writtenJson(Json document, const JsonThings& things,
                        const std::vector<CarriedThing>& carried) {
  document.erase("bbox");  // in the frame of the old map; it need not be there
  const std::vector<Json*> in = things.in(document);
  if (in.empty()) document["state"] = nameOf(CarryState::carried);  // by which it is known again
  for (std::size_t i = 0; i < in.size(); ++i) {
    in[i]->erase("bbox");
    auto pose = carried[i].poses.begin();
    things.visitPlaces(*in[i], [&](Json& x, Json& y, bool) {
      x = rounded(pose->x), y = rounded(pose->y);
      ++pose;
    });
    setState(things.membersOf(*in[i]), carried[i]);
  }
  return textOf(document);
}

MarkedFile marked(Json document, const std::string& file, const JsonThings& things) {
  MarkedFile result;
  result.kind = things.kind, result.files = {file};
  PlaceIndex placeOf(result.places);
  for (Json* json : things.in(document)) {
    Thing thing{things.nameOf(*json), {}};
    if (thing.name.empty()) thing.name = std::to_string(result.things.size() + 1);
    try {
      things.visitPlaces(*json, [&](Json& x, Json& y, bool isCorner) {
        thing.places.push_back(placeOf({metres(x), metres(y)}, isCorner));
      });
    } catch (const Broken& broken) {
      throw Broken{std::string(things.kind) + " " + thing.name, broken.problem};
    }
    result.things.push_back(std::move(thing));
  }
  result.write = [document = std::move(document), file, things](
                     const std::vector<CarriedThing>& carried, const GridFrame&) {
    return std::vector<NamedBytes>{{file, writtenJson(document, things, carried)}};
  };
  return result;
}

/** Visits [x, y, ...], or lists of these nested in any way. @throws Broken for anything else. */
void visitPositions(Json& coordinates, bool areCorners, const VisitPlace& visit) {
  if (!coordinates.is_array()) throw Broken{"", "has coordinates that are no list"};
  if (coordinates.size() >= 2 && coordinates[0].is_number())
    visit(coordinates[0], coordinates[1], areCorners);
  else
    for (Json& inner : coordinates) visitPositions(inner, areCorners, visit);
}

void visitXY(Json& object, const VisitPlace& visit) {
  if (!object.is_object() || !object.contains("x") || !object.contains("y"))
    throw Broken{"", "has no x and y"};
  visit(object["x"], object["y"], false);
}

/** The things of a document, to be written on lines of their own.
 *  @throws DataError in the name of `file` where it is none, or not as `things` says. */
MarkedFile markedJson(const std::string& text, const std::string& file, const JsonThings& things) {
  return readDocument(text, file, "", "repair it", [&](const JsonNode& top) {
    return marked(top.json, fileName(file), things);
  });
}

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

bool isOfType(const Json& json, const char* type) {
  return json.is_object() && json.contains("type") && json["type"] == type;
}

/** A geometry, of a feature or bare. */
bool isGeometry(const Json& json) {
  return json.is_object() && (json.contains("coordinates") || json.contains("geometries"));
}

/** Those that lie somewhere. */
std::vector<Json*> featuresIn(Json& document) {
  std::vector<Json*> features;
  const auto add = [&](Json& feature) {
    if (!feature.contains("geometry") || !feature["geometry"].is_null())
      features.push_back(&feature);
  };
  if (isOfType(document, "Feature") || isGeometry(document)) return add(document), features;
  if (!isOfType(document, "FeatureCollection") || !document.contains("features") ||
      !document["features"].is_array())
    throw Broken{"", "is no GeoJSON: it has neither features nor coordinates"};
  Json& all = document["features"];
  for (Json& feature : all) {
    if (!isOfType(feature, "Feature"))
      throw Broken{"features[" + std::to_string(&feature - &all[0]) + "]", "is no feature"};
    add(feature);
  }
  return features;
}

/** The member of its properties; null where it has none. */
const Json& propertyOf(const Json& feature, const char* name) {
  static const Json kNone;
  if (!feature.contains("properties") || !feature["properties"].is_object()) return kNone;
  const Json& properties = feature["properties"];
  return properties.contains(name) ? properties[name] : kNone;
}

std::string nameOfFeature(const Json& feature) {
  for (const char* name : {"name", "id"}) {
    const Json& value = propertyOf(feature, name);
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number()) return value.dump();
  }
  for (const char* kind : {"room", "passage"})  // of extract's
    if (const Json& value = propertyOf(feature, kind); value.is_number())
      return std::string(kind) + " " + value.dump();
  return "";
}

void visitGeometry(Json& geometry, const VisitPlace& visit) {
  if (!isGeometry(geometry)) throw Broken{"", "has a geometry without coordinates"};
  const bool isArea = isOfType(geometry, "Polygon") || isOfType(geometry, "MultiPolygon");
  if (geometry.contains("coordinates"))
    return visitPositions(geometry["coordinates"], isArea, visit);
  for (Json& inner : geometry["geometries"]) visitGeometry(inner, visit);
}

void visitFeature(Json& feature, const VisitPlace& visit) {
  if (!isOfType(feature, "Feature")) return visitGeometry(feature, visit);
  if (!feature.contains("geometry")) throw Broken{"", "has no geometry"};
  visitGeometry(feature["geometry"], visit);
}

Json& membersOfFeature(Json& feature) {
  return isOfType(feature, "Feature") ? feature["properties"] : feature;
}

/** Edges of a route graph begin and end where their nodes lie, whatever corners they have there. */
void joinRoutes(Json document, MarkedFile& marked) {
  const std::vector<Json*> features = featuresIn(document);
  std::map<Json, std::size_t> nodes;
  for (std::size_t i = 0; i < features.size(); ++i)
    if (const Json& id = propertyOf(*features[i], "id");
        !id.is_null() && marked.things[i].places.size() == 1)
      nodes.emplace(id, marked.things[i].places.front());
  const auto join = [&](const Json& id, std::size_t& place) {
    if (const auto node = nodes.find(id); node != nodes.end()) place = node->second;
  };
  for (std::size_t i = 0; i < features.size(); ++i) {
    std::vector<std::size_t>& places = marked.things[i].places;
    if (places.size() < 2) continue;
    join(propertyOf(*features[i], "startid"), places.front());
    join(propertyOf(*features[i], "endid"), places.back());
  }
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

bool looksLikeGeojson(const std::string& text) { return firstLetter(text) == '{'; }

MarkedFile geojsonPlaces(const std::string& text, const std::string& file) {
  MarkedFile marked = markedJson(
      text, file, {"feature", featuresIn, nameOfFeature, visitFeature, membersOfFeature});
  joinRoutes(Json::parse(text), marked);
  return marked;
}

}  // namespace roomgraph
