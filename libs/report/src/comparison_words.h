#pragma once
#include <filesystem>
#include <string>

#include "roomgraph/ledger/SiteRoom.h"

namespace roomgraph {

/** As all files of a comparison write it. */
inline const char* nameOf(RoomSighting sighting) {
  if (sighting == RoomSighting::seen) return "seen";
  return sighting == RoomSighting::gone ? "gone" : "unvisited";
}

inline std::string fileName(const std::string& file) {
  return std::filesystem::path(file).filename().string();
}

}  // namespace roomgraph
