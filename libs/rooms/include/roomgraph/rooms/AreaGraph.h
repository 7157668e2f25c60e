#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/base/Ids.h"
#include "roomgraph/geometry/Polygon.h"

namespace roomgraph {

using AreaId = Id<struct AreaTag>;        ///< a place in AreaGraph::areas
using PassageId = Id<struct PassageTag>;  ///< a place in AreaGraph::passages

/** A room or a piece of corridor. */
struct Area {
  RoomId room;                      ///< of the room graph; none for a piece of corridor
  Polygon polygon;                  ///< its corners are obstacles [m, map frame]
  Point widestPlace;                ///< centre of the largest disc that fits in
  double inscribedRadius = 0;       ///< of that disc [m]
  std::vector<PassageId> passages;  ///< ascending

  [[nodiscard]] bool isRoom() const { return bool(room); }  ///< else corridor
};

/** An opening between two obstacles in which two areas meet. */
struct Passage {
  AreaId a, b;       ///< the smaller one first
  Point from, to;    ///< its two ends, which are obstacles [m, map frame]
  double width = 0;  ///< distance of its ends [m]
  [[nodiscard]] Point middle() const { return midpoint(from, to); }  ///< [m, map frame]
};

/** As many areas can be told apart in 16 bits. */
constexpr std::size_t kMaxLabelledAreas = 65535;

/** The free space of a map in areas that meet in passages (Area Graph; Hou et al. 2019). */
struct AreaGraph {
  std::vector<Area> areas;        ///< rooms in the order of the room graph, then corridors
  std::vector<Passage> passages;  ///< ordered by a, b and place
  /** Per cell of the map, row-major, row 0 lowest: 1 + the index of its area; 0 for none. */
  std::vector<std::uint16_t> labels;
};

}  // namespace roomgraph
