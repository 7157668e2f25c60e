#include "json_things.h"

#include <cmath>
#include <map>

#include "roomgraph/base/file_name.h"
#include "roomgraph/base/read_document.h"

namespace roomgraph {
namespace {

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
  const std::vector<Json*> in = things.in(document);
  for (std::size_t i = 0; i < in.size(); ++i) {
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
  result.kind = things.kind;
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

}  // namespace

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

MarkedFile markedJson(const std::string& text, const std::string& file, const JsonThings& things) {
  return readDocument(text, file, "", "repair it", [&](const JsonNode& top) {
    return marked(top.json, fileName(file), things);
  });
}

}  // namespace roomgraph
