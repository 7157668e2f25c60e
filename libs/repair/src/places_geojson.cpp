#include "roomgraph/repair/places_geojson.h"

#include <map>

#include "json_things.h"
#include "roomgraph/base/read_document.h"

namespace roomgraph {
namespace {

bool isOfType(const Json& json, const char* type) {
  return json.is_object() && json.contains("type") && json["type"] == type;
}

/** A geometry, of a feature or bare. */
bool isGeometry(const Json& json) {
  return json.is_object() && (json.contains("coordinates") || json.contains("geometries"));
}

std::vector<Json*> featuresIn(Json& document) {
  if (isOfType(document, "Feature") || isGeometry(document)) return {&document};
  if (!isOfType(document, "FeatureCollection") || !document.contains("features") ||
      !document["features"].is_array())
    throw Broken{"", "is no GeoJSON: it has neither features nor coordinates"};
  std::vector<Json*> features;
  for (Json& feature : document["features"]) {
    if (!isOfType(feature, "Feature"))
      throw Broken{"features[" + std::to_string(features.size()) + "]", "is no feature"};
    features.push_back(&feature);
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
  return "";
}

void visitGeometry(Json& geometry, const VisitPlace& visit) {
  if (geometry.is_null()) return;  // a feature that lies nowhere
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

bool looksLikeGeojson(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && text[first] == '{';
}

MarkedFile geojsonPlaces(const std::string& text, const std::string& file) {
  MarkedFile marked = markedJson(
      text, file, {"feature", featuresIn, nameOfFeature, visitFeature, membersOfFeature});
  joinRoutes(Json::parse(text), marked);
  return marked;
}

}  // namespace roomgraph
