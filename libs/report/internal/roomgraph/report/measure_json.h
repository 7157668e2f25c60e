#pragma once
#include "roomgraph/base/Json.h"
#include "roomgraph/ledger/SiteRoom.h"
#include "roomgraph/measures/Measure.h"

namespace roomgraph {

/** A figure as all files hold it, under its name. */
Json measureJson(const Measure& measure);

/** As all files write it. */
inline const char* nameOf(RoomSighting sighting) {
  if (sighting == RoomSighting::seen) return "seen";
  return sighting == RoomSighting::gone ? "gone" : "unvisited";
}

}  // namespace roomgraph
