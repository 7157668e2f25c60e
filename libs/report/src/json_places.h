#pragma once
#include <cmath>

#include "roomgraph/ledger/SiteRoom.h"
#include "stability_json.h"

namespace roomgraph {

/** As files hold numbers: to 0.0001, never -0. */
inline double toTenthMillimetre(double value) { return std::round(value * 1e4) / 1e4 + 0.0; }

/** [[x, y], ...] */
inline Json ringJson(const Ring& ring) {
  Json json = Json::array();
  for (const Point p : ring) json.push_back({toTenthMillimetre(p.x), toTenthMillimetre(p.y)});
  return json;
}

inline Json ringsJson(const std::vector<Ring>& rings) {
  Json json = Json::array();
  for (const Ring& ring : rings) json.push_back(ringJson(ring));
  return json;
}

inline Json doorsJson(const std::vector<SiteDoor>& doors) {
  Json json = Json::array();
  for (const SiteDoor& door : doors)
    json.push_back({{"x", toTenthMillimetre(door.place.x)},
                    {"y", toTenthMillimetre(door.place.y)},
                    {"width", toTenthMillimetre(door.width)},
                    {"to", door.to.empty() ? Json(nullptr) : Json(door.to)}});
  return json;
}

}  // namespace roomgraph
