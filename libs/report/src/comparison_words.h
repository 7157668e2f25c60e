#pragma once
#include <string>

#include "roomgraph/base/file_name.h"
#include "roomgraph/ledger/SiteRoom.h"

namespace roomgraph {

/** As all files of a comparison write it. */
inline const char* nameOf(RoomSighting sighting) {
  if (sighting == RoomSighting::seen) return "seen";
  return sighting == RoomSighting::gone ? "gone" : "unvisited";
}

}  // namespace roomgraph
