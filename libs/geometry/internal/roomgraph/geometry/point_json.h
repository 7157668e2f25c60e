#pragma once
#include <string>
#include <vector>

#include "roomgraph/base/Json.h"
#include "roomgraph/geometry/Polygon.h"

namespace roomgraph {

/** As files hold it, see rounded(double). */
inline Point rounded(Point p) { return {rounded(p.x), rounded(p.y)}; }

/** [x, y], rounded. */
inline Json pointJson(Point p) { return {rounded(p.x), rounded(p.y)}; }

/** A coordinate in metres. Throws Broken where it is none, or beyond kFarthestPlace: who draws it
 *  would count with infinities. */
double readCoordinate(const JsonNode& node);
/** [x, y]. Throws Broken where it is not a pair of coordinates. */
Point readPoint(const JsonNode& node);
std::vector<Point> readPoints(const JsonNode& node);
/** The members "polygon" and "holes" of a room or an area. */
Polygon readPolygon(const JsonNode& node);

/** [x,y], as addNumber writes numbers. */
void addPoint(std::string& json, Point p);
/** [[x,y],...] */
void addPoints(std::string& json, const std::vector<Point>& points);

}  // namespace roomgraph
