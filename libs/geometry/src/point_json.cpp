#include "roomgraph/geometry/point_json.h"

#include <cmath>

#include "roomgraph/base/sequences.h"

namespace roomgraph {

double readCoordinate(const JsonNode& node) {
  const double metres = node.number();
  if (std::abs(metres) > kFarthestPlace) throw Broken{node.place, "is too far away to be a place"};
  return metres;
}

Point readPoint(const JsonNode& node) {
  const auto numbers = node.list();
  if (numbers.size() != 2) throw Broken{node.place, "is not a pair [x, y]"};
  return {readCoordinate(numbers[0]), readCoordinate(numbers[1])};
}

std::vector<Point> readPoints(const JsonNode& node) { return mapped(node.list(), readPoint); }

Polygon readPolygon(const JsonNode& node) {
  Polygon polygon{readPoints(node["polygon"]), {}};
  for (const JsonNode& hole : node["holes"].list()) polygon.holes.push_back(readPoints(hole));
  return polygon;
}

void addPoint(std::string& json, Point p) {
  json += '[';
  addNumber(json, p.x);
  json += ',';
  addNumber(json, p.y);
  json += ']';
}

void addPoints(std::string& json, const std::vector<Point>& points) {
  json += '[';
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i) json += ',';
    addPoint(json, points[i]);
  }
  json += ']';
}

}  // namespace roomgraph
