#pragma once

#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/point_json.h"
#include "roomgraph/ledger/SiteRoom.h"
#include "roomgraph/measures/Measure.h"

namespace roomgraph {

/** [[x, y], ...] */
inline Json ringJson(const Ring& ring) { return mapped(ring, pointJson); }

/** The members "x" and "y". */
inline Point readPlace(const JsonNode& node) {
  return {readCoordinate(node["x"]), readCoordinate(node["y"])};
}

inline Json doorJson(const SiteDoor& door) {
  return {{"x", rounded(door.place.x)},
          {"y", rounded(door.place.y)},
          {"width", rounded(door.width)},
          {"to", door.to.empty() ? Json(nullptr) : Json(door.to)}};
}

/** A room of a site as it lies, of a comparison or of the file of names. */
inline Json placedRoomJson(const SiteRoom& room, const Json& doors) {
  return {{"id", room.id},
          {"name", room.name},
          {"kind", room.isCorridor ? "corridor" : "room"},
          {"x", rounded(room.center.x)},
          {"y", rounded(room.center.y)},
          {"area_m2", rounded(room.area)},
          {"polygon", ringJson(room.polygon.outer)},
          {"holes", mapped(room.polygon.holes, ringJson)},
          {"doors", doors}};
}

/** Figures as all files hold them, by their names. */
Json measuresJson(const std::vector<Measure>& measures);

}  // namespace roomgraph
