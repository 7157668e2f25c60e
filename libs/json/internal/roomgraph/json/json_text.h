#pragma once
#include <string>
#include <vector>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** Coordinates as JSON text, rounded as files hold them. Most of a file is coordinates, and text
 *  written at once takes a fraction of the time of a tree of values. null where not finite. */
void addNumber(std::string& json, double value);
/** [x,y] */
void addPoint(std::string& json, Point p);
/** [[x,y],...] */
void addPoints(std::string& json, const std::vector<Point>& points);

}  // namespace roomgraph
