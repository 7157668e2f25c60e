#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "roomgraph/base/Ids.h"
#include "roomgraph/geometry/Polygon.h"

namespace roomgraph {

/** A big and empty space (paper II), as found by find_rooms. Its id is its place in the vector. */
struct Room {
  Polygon polygon;             ///< its corners are obstacles [m, map frame]
  Point widestPlace;           ///< centre of the largest disc between the obstacles that fits in
  double inscribedRadius = 0;  ///< of that disc [m]
  std::uint32_t region = 0;    ///< of Regions, which it was traced from; not kept in files
  std::optional<double> seen = {};  ///< see Area; not kept in files
};

using Rooms = std::vector<Room>;  ///< by RoomId

}  // namespace roomgraph
