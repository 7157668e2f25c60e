#pragma once
#include <functional>
#include <string>
#include <vector>

#include "roomgraph/base/Json.h"
#include "roomgraph/repair/MarkedFile.h"

namespace roomgraph {

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

/** Visits [x, y, ...], or lists of these nested in any way. @throws Broken for anything else. */
void visitPositions(Json& coordinates, bool areCorners, const VisitPlace& visit);
/** Visits "x" and "y" of an object. @throws Broken where they are missing. */
void visitXY(Json& object, const VisitPlace& visit);

/** The things of a document, to be written on lines of their own.
 *  @throws DataError in the name of `file` where it is none, or not as `things` says. */
MarkedFile markedJson(const std::string& text, const std::string& file, const JsonThings& things);

}  // namespace roomgraph
